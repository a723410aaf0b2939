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

/// A tool that motions would cut with, and that has no cutter.
struct MissingTool {
    int number = 0;         ///< 0: none in the spindle
    std::uint32_t line = 0; ///< source line of the first motion that misses it
    bool called = true;     ///< by the program; else the spindle is as it was at the start
};

/// A tool that motions cut with, and whose sizes nobody has confirmed.
struct UnconfirmedTool {
    int number = 0;
    std::uint32_t line = 0; ///< source line of the first motion with it
    std::string cutter;     ///< its spec
    ToolOrigin origin;
};

/// The index of the first motion after the first tool change; motionCount() where no tool is changed.
[[nodiscard]] std::size_t firstMotionWithCalledTool(const Program& program);

/// Whether the program ever changes tools.
[[nodiscard]] bool callsTool(const Program& program);

/// The tool that is taken to be in the spindle at the start of a program that cuts before it calls one,
/// where the setup does not say: the only one of the table if the program never changes tools, else T0 if
/// the table has it, for that is the number a control has before any tool is called.
[[nodiscard]] std::optional<int> assumedTool(const Program& program, const Setup& setup);
/// The same for a setup that does not say which tool is in the spindle.
[[nodiscard]] std::optional<int> assumedTool(const Program& program, const ToolTable& tools);

/// Which cutter a motion has, and which tools have none: a pure function of program and setup, known before
/// anything is cut. Value type.
class ToolChoice {
public:
    ToolChoice() = default;
    ToolChoice(const Program& program, const Setup& setup);

    /// The number of the tool assumed to be in the spindle, if one is: nobody has said so.
    [[nodiscard]] std::optional<int> assumed() const { return m_assumed; }
    /// Whether a motion that names tool `number` is taken to be cut with the assumed one. It may name that
    /// itself: of a program that was interpreted with it (withAssumedTool()).
    [[nodiscard]] bool isAssumed(int number) const {
        return m_assumed && (number == 0 || number == *m_assumed);
    }
    /// Whether the program ever calls a tool.
    [[nodiscard]] bool callsTool() const { return m_callsTool; }
    /// The tool of a motion that names tool `number` (0: none, or T0 where the table has it).
    [[nodiscard]] int tool(int number) const { return number == 0 ? m_assumed.value_or(0) : number; }
    /// Each once, in the order in which the program misses them. A rapid misses its tool too, for it may cut;
    /// but with no tool in the spindle it is only on its way to one.
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
