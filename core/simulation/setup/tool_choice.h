// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/nc/program/program.h"
#include "core/simulation/setup/setup.h"

namespace proveout {

/// A tool that motions would cut with, but that has no cutter.
struct MissingTool {
    int number = 0;         ///< 0: none in the spindle
    std::uint32_t line = 0; ///< source line of the first motion that needs it
    bool called = true;     ///< by the program; otherwise the spindle is as at the start
};

/// A tool that motions cut with, and whose sizes are not confirmed.
struct UnconfirmedTool {
    int number = 0;
    std::uint32_t line = 0; ///< source line of the first motion with it
    std::string cutter;     ///< its spec
    ToolOrigin origin;
};

/// The index of the first motion after the first tool change; motionCount() if there is no tool change.
[[nodiscard]] std::size_t firstMotionWithCalledTool(const Program& program);

/// Whether the program ever changes tools.
[[nodiscard]] bool callsTool(const Program& program);

/// The tool assumed to be in the spindle at the start of a program that cuts before it calls a tool, if the
/// setup does not say: the only one of the table if the program never changes tools, otherwise T0 if the
/// table has it, because that is the number a control has before any tool is called.
[[nodiscard]] std::optional<int> assumedTool(const Program& program, const Setup& setup);
/// The same for a setup that does not say which tool is in the spindle.
[[nodiscard]] std::optional<int> assumedTool(const Program& program, const ToolTable& tools);

/// Which cutter a motion has, and which tools have none: a pure function of program and setup, known before
/// anything is cut. Value type.
class ToolChoice {
public:
    ToolChoice() = default;
    ToolChoice(const Program& program, const Setup& setup);

    /// The number of the tool assumed to be in the spindle, if there is one; the setup does not say so.
    [[nodiscard]] std::optional<int> assumed() const { return m_assumed; }
    /// Whether a motion that names tool `number` is assumed to be cut with the assumed tool. It may name that
    /// tool itself, in a program that was interpreted with it (withAssumedTool()).
    [[nodiscard]] bool isAssumed(int number) const {
        return m_assumed && (number == 0 || number == *m_assumed);
    }
    /// Whether the program ever calls a tool.
    [[nodiscard]] bool callsTool() const { return m_callsTool; }
    /// The tool of a motion that names tool `number` (0: none, or T0 where the table has it).
    [[nodiscard]] int tool(int number) const { return number == 0 ? m_assumed.value_or(0) : number; }
    /// Each once, in the order in which the program first needs them. A rapid needs its tool too, because it
    /// may cut; but with no tool in the spindle it is only on its way to one.
    [[nodiscard]] const std::vector<MissingTool>& missing() const { return m_missing; }
    /// Each once, in the order in which the program uses them.
    [[nodiscard]] const std::vector<UnconfirmedTool>& unconfirmed() const { return m_unconfirmed; }

private:
    std::optional<int> m_assumed;
    bool m_callsTool = false;
    std::vector<MissingTool> m_missing;
    std::vector<UnconfirmedTool> m_unconfirmed;
};

} // namespace proveout
