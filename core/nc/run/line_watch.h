// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>

#include "core/nc/program/line_values.h"
#include "core/nc/state/machine_state.h"
#include "core/nc/text/expression.h"
#include "core/nc/text/lexer.h"

namespace proveout {

/// Records what one line of the main text means at its first execution, and how often it is executed.
class LineWatch {
public:
    /// `line`: 1-based; 0: none is watched.
    explicit LineWatch(std::uint32_t line) { m_values.line = line; }

    [[nodiscard]] bool watches(std::size_t index) const { return index + 1 == m_values.line; }
    [[nodiscard]] bool active() const { return m_values.line > 0; }
    [[nodiscard]] const LineValues& values() const { return m_values; }

    /// Before and after an execution of it; `modes` are the codes in force.
    void begin(std::string_view text, const ReadContext& context, std::vector<ControlState::Mode> modes);
    void end(const Line& line, std::string_view text, const ReadContext& context, const MachineState& state,
             std::vector<ControlState::Mode> modes);

private:
    void noteWords(const Line& line, const Dialect& dialect, const MachineState& state);

    LineValues m_values;
};

} // namespace proveout
