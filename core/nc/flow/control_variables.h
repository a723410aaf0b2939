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

/// The variables of the control as the lines of a program read and write them: the parameters, and above them
/// what the macro language of the dialect shows of the machine. Keeps references to its arguments.
class ControlVariables {
public:
    /// `assumedReported`: the numbers of variables that were reported as assumed.
    ControlVariables(const Dialect& dialect, bool blockDelete, ControlMemory& memory,
                     std::set<int>& assumedReported, Program& program, Reporter& reporter);
    ControlVariables(const ControlVariables&) = delete;
    ControlVariables& operator=(const ControlVariables&) = delete;

    /// What lines are read with.
    [[nodiscard]] const ReadContext& context() const { return m_context; }
    [[nodiscard]] OffsetRegisters& registers() { return m_registers; }

    /// Executes the assignments of a line; `line` is the one of the main text, 1-based.
    void assign(std::span<const Assignment> assignments, std::uint32_t line);

    /// Reports what was read that only the machine knows: from here on the program depends on it.
    void reportReads();
    /// What was read so far was no use of it by the program.
    void forgetReads();
    /// Whether an expression depended on the state of the machine since the last call of this.
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
    const SystemValues& m_system; ///< the one of these three that the dialect has
    const ReadContext m_context;
};

} // namespace proveout
