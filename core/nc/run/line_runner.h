// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nc/flow/call_stack.h"
#include "core/nc/flow/control_variables.h"
#include "core/nc/program/line_values.h"
#include "core/nc/run/block_executor.h"
#include "core/nc/run/flow_runner.h"
#include "core/nc/run/interpreter.h"
#include "core/nc/run/line_reader.h"
#include "core/nc/run/line_watch.h"
#include "core/nc/run/run_state.h"
#include "core/nc/text/lexer.h"

namespace proveout {

/// Runs the current line of the call stack, from its text to motions, jumps and calls. Keeps references to
/// its arguments.
class LineRunner {
public:
    LineRunner(const NcText& text, const InterpretOptions& options, const Dialect& dialect,
               const WorkContext& context, RunState& run, CallStack& calls, Program& program,
               Reporter& reporter);

    /// Once, before the first line.
    void begin() { m_reader.begin(); }
    /// False if the rest of the program is not needed: it is too long, or the line is watched.
    [[nodiscard]] bool run();
    /// At the end of a text or program: returns to the caller; false in the main program.
    [[nodiscard]] bool leaveText() { return m_flow.leaveText(); }

    /// Whether the lines that ran since the last call of this function depend on more than parameters.
    [[nodiscard]] bool consumeDependence();
    [[nodiscard]] ControlState controlState() const;
    [[nodiscard]] bool hasModalMacro() const { return m_flow.hasModalMacro(); }
    [[nodiscard]] OffsetRegisters& registers() { return m_variables.registers(); }
    [[nodiscard]] std::size_t firstTextFrom(std::size_t index) { return m_reader.firstTextFrom(index); }
    [[nodiscard]] const LineWatch& watch() const { return m_watch; }

private:
    void runLine();
    void runWatched();
    void runWords();
    void runStatement();
    void runBlock();

    const InterpretOptions& m_options;
    const Dialect& m_dialect;
    const CodeTable& m_codes;
    RunState& m_run;
    CallStack& m_calls;
    ControlVariables m_variables;
    LineReader m_reader;
    BlockExecutor m_blocks;
    FlowRunner m_flow;
    LineWatch m_watch;
    Line m_line;
    bool m_tooLong = false;
};

} // namespace proveout
