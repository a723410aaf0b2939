// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/nc/flow/call_stack.h"
#include "core/nc/flow/control_variables.h"
#include "core/nc/flow/macro_flow.h"
#include "core/nc/flow/o_word_flow.h"
#include "core/nc/flow/unreachable.h"
#include "core/nc/run/block_executor.h"
#include "core/nc/run/line_reader.h"
#include "core/nc/state/control_memory.h"
#include "core/nc/text/lexer.h"

namespace proveout {

/// Runs a program through its jumps, loops, calls and returns, with the flow control of its dialect. Keeps
/// references to its arguments.
class FlowRunner {
public:
    FlowRunner(const Dialect& dialect, ControlVariables& variables, ControlMemory& memory,
               const ReadState& read, Unreachable& unreachable, CallStack& calls, BlockExecutor& blocks,
               Reporter& reporter);

    /// Executes the O-word of a line.
    void runOWord(const Line& line);
    /// Executes a statement of custom macro B. True if words remain to be executed after its THEN: they are
    /// in `line`.
    [[nodiscard]] bool runStatement(Line& line);
    /// Executes the request of a block; `moved`: whether it has moved the machine.
    void follow(const Line& line, const FlowRequest& request, bool moved);
    /// At the end of a text or program: returns to the caller; false in the main program.
    [[nodiscard]] bool leaveText();

    /// Whether a macro runs after every motion.
    [[nodiscard]] bool hasModalMacro() const { return m_macros.modal(); }

private:
    bool run(const FlowRequest& request);
    void execute(const std::function<bool()>& order);
    void checkPlaceOfCall(const Line& line, const FlowRequest& request);
    void noteLeaving(const Line& line);
    void updateProgramNumber();

    const Dialect& m_dialect;
    const bool m_macroB = m_dialect.macros == MacroLanguage::macroB;
    ControlVariables& m_variables;
    MachineState& m_state;
    ModalSaves& m_saves;
    const ReadState& m_read;
    Unreachable& m_unreachable;
    CallStack& m_calls;
    BlockExecutor& m_blocks;
    Reporter& m_reporter;
    OWordFlow m_oWords;
    MacroFlow m_macros;
};

} // namespace proveout
