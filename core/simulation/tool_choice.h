// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/cutter/tool_table.h"
#include "core/nc/program.h"

namespace proveout {

/// Which cutter a motion has. A program that never changes tools, with exactly one cutter in the table, is
/// taken to run with that one. Value type.
class ToolChoice {
public:
    ToolChoice() = default;
    ToolChoice(const Program& program, const ToolTable& tools);

    /// The number of the tool assumed to be in the spindle, if one is.
    [[nodiscard]] std::optional<int> assumed() const { return m_assumed; }
    /// The tool of a motion that names tool `number` (0: none).
    [[nodiscard]] int tool(int number) const { return number == 0 ? m_assumed.value_or(0) : number; }

private:
    std::optional<int> m_assumed;
};

} // namespace proveout
