// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/rules/tool_comments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/figures_argument.h"
#include "core/cutter/shapes.h"
#include "core/verification/findings/rule_findings.h"

namespace proveout {

namespace {

/// Shapes that comments do not keep apart: an end mill may have a corner radius that they leave out.
enum class Kind : std::uint8_t { mill, ball, pointed, drill, finisher, any };

struct ShapeKind {
    std::string_view shape;
    Kind kind;
    bool hasDiameter; ///< what comments call its diameter is the largest one
};

constexpr std::array kKinds{
    ShapeKind{"flat", Kind::mill, true},       ShapeKind{"bull", Kind::mill, true},
    ShapeKind{"face", Kind::mill, true},       ShapeKind{"taper", Kind::mill, false},
    ShapeKind{"ball", Kind::ball, true},       ShapeKind{"taperball", Kind::ball, false},
    ShapeKind{"lollipop", Kind::ball, true},   ShapeKind{"cone", Kind::pointed, true},
    ShapeKind{"chamfer", Kind::pointed, true}, ShapeKind{"spot", Kind::any, true},
    ShapeKind{"centre", Kind::any, false},     ShapeKind{"drill", Kind::drill, true},
    ShapeKind{"reamer", Kind::finisher, true}, ShapeKind{"tap", Kind::finisher, true},
};

ShapeKind kindOf(const CutterShape* shape) {
    if (shape != nullptr)
        for (const ShapeKind& row : kKinds)
            if (row.shape == shape->key)
                return row;
    return {"", Kind::any, false};
}

/// Comments round inches to few figures.
bool isSameDiameter(double stated, double given) {
    return std::abs(stated - given) <= std::max(0.03, 0.01 * given);
}

/// Where a comment and a tool that was given differ; null: nowhere.
const FindingRow* differenceOf(const Cutter& stated, const ToolOrigin& origin, const Cutter& given) {
    const ShapeKind one = kindOf(shapeOf(stated.spec()));
    const ShapeKind other = kindOf(shapeOf(given.spec()));
    const bool kinds = origin.states("shape") && one.kind != Kind::any && other.kind != Kind::any;
    if (kinds && one.kind != other.kind)
        return &rule_finding::kCommentShape;
    const bool diameters = one.hasDiameter && other.hasDiameter;
    return diameters && !isSameDiameter(2 * stated.radius(), 2 * given.radius())
               ? &rule_finding::kCommentDiameter
               : nullptr;
}

/// What the sentence of a difference says of a cutter.
Argument described(const FindingRow& row, const Cutter& cutter) {
    if (&row == &rule_finding::kCommentShape)
        return shapeOf(cutter.spec())->label;
    return figures("{:.6g}", 2 * cutter.radius());
}

} // namespace

Diagnostics differingComments(const ToolProposals& proposals, const ToolTable& tools) {
    Diagnostics out;
    for (const auto& [number, stated] : proposals.tools.tools()) {
        const Cutter* given = tools.find(number);
        const ToolOrigin* origin = proposals.tools.unconfirmedOrigin(number);
        if (given == nullptr || origin == nullptr || tools.unconfirmedOrigin(number) != nullptr ||
            !proposals.called.contains(number))
            continue;
        const FindingRow* row = differenceOf(stated, *origin, *given);
        if (row == nullptr)
            continue;
        Diagnostic difference =
            diagnosticOf(*row, {std::to_string(number), described(*row, stated), described(*row, *given)});
        difference.where = {static_cast<int>(origin->line), 1, 0};
        out.push_back(std::move(difference));
    }
    return out;
}

} // namespace proveout
