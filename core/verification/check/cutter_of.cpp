// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/check/cutter_of.h"

#include <algorithm>
#include <array>

#include "core/cutter/tool_spec.h"
#include "core/simulation/run/cutting_findings.h"
#include "core/verification/findings/rule_findings.h"

namespace proveout {

namespace {

constexpr std::array kOfWholeTool{&cutting_finding::kHolderCollision, &cutting_finding::kShankCollision,
                                  &cutting_finding::kNeckInStock,     &rule_finding::kFixtureCollision,
                                  &rule_finding::kFixtureNear,        &rule_finding::kTravelLimit,
                                  &rule_finding::kHolderNear,         &rule_finding::kShankNear,
                                  &rule_finding::kToolChangePosition};

bool isOfWholeTool(std::string_view finding) {
    return std::ranges::any_of(kOfWholeTool, [&](const FindingRow* row) { return finding == row->id; });
}

bool isLimit(std::string_view key) {
    return key == "ramp" || key.starts_with("max");
}

} // namespace

std::string cutterOf(std::string_view spec, std::string_view finding) {
    ToolSpec tool = readSpec(spec);
    const bool whole = isOfWholeTool(finding);
    for (const ShapeKey& key : keysOf(tool.shape)) {
        const std::string_view name = key.key;
        if (!isLimit(name) && (whole || (name != "so" && name != "holder")))
            continue;
        if (key.isText())
            tool.texts[key.key].clear();
        else
            tool.values[key.key] = key.defaultValue;
    }
    return writeSpec(tool);
}

} // namespace proveout
