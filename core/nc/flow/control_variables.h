// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <span>

#include "core/nc/flow/macro_variables.h"
#include "core/nc/program/program.h"
#include "core/nc/program/reporter.h"
#include "core/nc/state/control_memory.h"
#include "core/nc/state/machine_values.h"
#include "core/nc/state/offset_registers.h"
#include "core/nc/text/expression.h"
#include "core/nc/text/lexer.h"

namespace proveout {

/// The variables of the control for the lines of a program: the parameters, and in addition the state of the
/// machine as the macro language of the dialect shows it. Keeps references to its arguments.
class ControlVariables {
public:
    /// `assumedReported`: the numbers of variables that were reported as assumed.
    ControlVariables(const Dialect& dialect, bool blockDelete, ControlMemory& memory,
                     std::set<int>& assumedReported, Program& program, Reporter& reporter);
    ControlVariables(const ControlVariables&) = delete;
    ControlVariables& operator=(const ControlVariables&) = delete;

    /// The context for reading lines.
    [[nodiscard]] const ReadContext& context() const { return m_context; }
    [[nodiscard]] OffsetRegisters& registers() { return m_registers; }

    /// Executes the assignments of a line; `line` is the one of the main text, 1-based.
    void assign(std::span<const Assignment> assignments, std::uint32_t line);

    /// Reports reads of values that only the machine knows: from here on the program depends on them.
    void reportReads();
    /// Discards the reads up to now, because the program does not use them.
    void forgetReads();
    /// Whether an expression depended on the state of the machine since the last call of this function.
    [[nodiscard]] bool consumeUse() { return m_system.consumeUse(); }

private:
    void assign(const Assignment& order, std::uint32_t line);
    bool assignInput(const Assignment& order);
    bool writeVariable(const Assignment& order, std::uint32_t line);
    [[nodiscard]] const SystemValues& systemValues() const;

    const Dialect& m_dialect;
    MachineState& m_state;
    Parameters& m_parameters;
    std::set<int>& m_assumedReported;
    Program& m_program;
    Reporter& m_reporter;
    OffsetRegisters m_registers;
    MachineValues m_machine;
    MacroVariables m_macroB;
    OffsetValues m_offsets;
    const SystemValues& m_system; ///< the one of the three that the dialect has
    const ReadContext m_context;
};

} // namespace proveout
