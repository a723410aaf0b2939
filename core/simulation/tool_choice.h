// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/cutter/tool_table.h"
#include "core/nc/program.h"

namespace proveout {

/// A tool that motions would cut with, and that has no cutter.
struct MissingTool {
    int number = 0;         ///< 0: none in the spindle
    std::uint32_t line = 0; ///< source line of the first motion that misses it
};

/// The tool that a program without tool changes, as far as it is, is taken to run with: the only one in the
/// table.
[[nodiscard]] std::optional<int> assumedTool(const Program& program, const ToolTable& tools);

/// Which cutter a motion has, and which tools have none: a pure function of program and tool table, known
/// before anything is cut. A program that never changes tools, with exactly one cutter in the table, is taken
/// to run with that one. Value type.
class ToolChoice {
public:
    ToolChoice() = default;
    ToolChoice(const Program& program, const ToolTable& tools);

    /// The number of the tool assumed to be in the spindle, if one is.
    [[nodiscard]] std::optional<int> assumed() const { return m_assumed; }
    /// The tool of a motion that names tool `number` (0: none).
    [[nodiscard]] int tool(int number) const { return number == 0 ? m_assumed.value_or(0) : number; }
    /// Each once, in the order in which the program misses them. A rapid misses its tool too, for it may cut;
    /// but with no tool in the spindle it is only on its way to one.
    [[nodiscard]] const std::vector<MissingTool>& missing() const { return m_missing; }

private:
    std::optional<int> m_assumed;
    std::vector<MissingTool> m_missing;
};

} // namespace proveout
