// SPDX-License-Identifier: GPL-3.0-or-later
// What CAM systems and posts write about tools in the comments of a program.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/cutter/tool_table.h"

namespace proveout {

/// What a comment states about one tool; mm and degrees. Value type.
struct ToolComment {
    std::optional<int> number; ///< 0 if a post writes T0
    const char* shape = "";    ///< key of cutterShapes(); empty: not stated
    std::optional<double> diameter;
    std::optional<double> cornerRadius;
    std::optional<double> sideAngle;     ///< as CAM systems list a taper: of the side, or of a drill's point
    std::optional<double> includedAngle; ///< of a cone, a chamfer mill or a drill
    std::optional<double> tipDiameter;
    std::optional<double> fluteLength;
    bool aboutTool = false; ///< it names a tool, a cutter or a bit, and not just some diameter

    /// Whether a cutter can be made from it: it has a diameter, and the diameter is one of a tool.
    [[nodiscard]] bool isComplete() const;
    /// Whether it states nothing.
    [[nodiscard]] bool isEmpty() const;
};

/// Reads the text of a comment, without its parentheses. `inch`: lengths without a unit are inches. Sizes
/// that no cutter has count as not stated, and so does everything in a comment about something that is not a
/// rotating cutter (a probe). Pure, any thread; reads at most the first 256 bytes.
[[nodiscard]] ToolComment readToolComment(std::string_view comment, bool inch);

/// Adds what `next` states to a description that is spread over several comments. False if both state the
/// same property, so that `next` begins another description; `tool` is then unchanged.
[[nodiscard]] bool extend(ToolComment& tool, const ToolComment& next);

/// A cutter and which of its values are defaults.
struct CommentCutter {
    Cutter cutter;
    std::vector<std::string> defaults; ///< ToolOrigin::defaults
};

/// The cutter that a complete description states. Errors: no shape has these sizes.
[[nodiscard]] Result<CommentCutter> makeCutter(const ToolComment& tool);

} // namespace proveout
