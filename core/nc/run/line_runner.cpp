// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/line_runner.h"

#include "core/nc/run/control_description.h"

namespace proveout {

LineRunner::LineRunner(const NcText& text, const InterpretOptions& options, const Dialect& dialect,
                       const WorkContext& context, RunState& run, CallStack& calls, Program& program,
                       Reporter& reporter)
    : m_options(options), m_dialect(dialect), m_codes(codesOf(dialect.id)), m_run(run), m_calls(calls),
      m_variables(dialect, options.blockDelete, run.memory, run.assumedVariables, program, reporter),
      m_reader(text, dialect, m_variables, run.memory.machine, run.read, calls, reporter),
      m_blocks(dialect, m_codes, options, context, run.memory, m_variables.registers(), run.ignored, calls,
               program, reporter),
      m_flow(dialect, m_variables, run.memory, run.read, run.unreachable, calls, m_blocks, reporter),
      m_watch(options.watchedLine) {}

bool LineRunner::run() {
    const bool watched = m_calls.inMainText() && m_watch.watches(m_calls.at());
    if (watched)
        runWatched();
    else
        runLine();
    return !m_tooLong && (!watched || m_options.watchToEnd);
}

ControlState LineRunner::controlState() const {
    return describe(m_run.memory.machine, m_run.memory.parameters, m_calls, m_codes, m_dialect);
}

void LineRunner::runWatched() {
    const std::string_view text = m_calls.currentText();
    // Reading a value for display does not count as use by the program.
    m_watch.begin(text, m_variables.context(), controlState().modes);
    m_variables.forgetReads();
    runLine();
    m_watch.end(m_line, text, m_variables.context(), m_run.memory.machine, controlState().modes);
    m_variables.forgetReads();
}

void LineRunner::runLine() {
    switch (m_reader.read(m_line)) {
    case LineReader::Content::nothing:
        break;
    case LineReader::Content::unreadable:
        m_blocks.skip(*m_line.error, m_reader.lineText());
        break;
    case LineReader::Content::words:
        runWords();
        break;
    }
}

void LineRunner::runWords() {
    if (m_line.flow)
        m_flow.runOWord(m_line);
    else if (m_line.statement)
        runStatement();
    else
        runBlock();
}

void LineRunner::runStatement() {
    if (!m_flow.runStatement(m_line))
        return;
    if (m_line.error)
        m_blocks.skip(*m_line.error, m_calls.currentText());
    else if (!m_line.block.empty() || !m_line.assignments.empty())
        runBlock();
}

void LineRunner::runBlock() {
    if (m_blocks.isData(m_line.block))
        return;
    m_blocks.ignoreCodes(m_line.block);
    m_variables.assign(m_line.assignments, m_calls.mainLineNumber());
    if (m_line.block.empty())
        return;
    FlowRequest request;
    const bool moved = m_blocks.execute(m_line, request);
    m_flow.follow(m_line, request, moved);
    m_tooLong = !m_run.memory.machine.ended && m_blocks.tooLong();
}

bool LineRunner::consumeDependence() {
    return m_variables.consumeUse() || m_flow.hasModalMacro() || m_run.memory.machine.dataInput;
}

} // namespace proveout
