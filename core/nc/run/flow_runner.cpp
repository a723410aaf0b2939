// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/flow_runner.h"
#include "core/nc/motions/known_axes.h"

#include <charconv>
#include <string>

#include "core/nc/text/messages.h"

namespace proveout {

FlowRunner::FlowRunner(const Dialect& dialect, ControlVariables& variables, ControlMemory& memory,
                       const ReadState& read, Unreachable& unreachable, CallStack& calls,
                       BlockExecutor& blocks, Reporter& reporter)
    : m_dialect(dialect), m_variables(variables), m_state(memory.machine), m_saves(memory.saves),
      m_read(read), m_unreachable(unreachable), m_calls(calls), m_blocks(blocks), m_reporter(reporter),
      m_oWords(calls, memory.parameters, variables.context(), reporter),
      m_macros(calls, variables.context(), reporter, memory.lint) {}

void FlowRunner::runOWord(const Line& line) {
    if (line.flow->kind == FlowKind::returns)
        noteLeaving(line);
    execute([&] { return m_oWords.run(*line.flow); });
    m_variables.reportReads();
}

bool FlowRunner::runStatement(Line& line) {
    if (line.statement->kind == StatementKind::gotoBlock)
        noteLeaving(line);
    const MacroFlow::Next next = m_macros.run(*line.statement);
    m_variables.reportReads();
    if (next == MacroFlow::Next::failed)
        forgetAxes(m_state, LetterSet("XYZ"), Forgotten::reported);
    if (next != MacroFlow::Next::rest)
        return false;
    readRest(m_calls.currentText(), m_macros.rest(), m_variables.context(), line);
    m_variables.reportReads();
    return true;
}

void FlowRunner::follow(const Line& line, const FlowRequest& request, bool moved) {
    checkPlaceOfCall(line, request);
    if (request.kind == FlowRequest::Kind::returns && !m_calls.inMainProgram())
        noteLeaving(line);
    if (request.kind != FlowRequest::Kind::none)
        execute([&] { return run(request); });
    if (moved && m_macroB && !m_macros.afterMotion())
        forgetAxes(m_state, LetterSet("XYZ"), Forgotten::reported);
}

bool FlowRunner::run(const FlowRequest& request) {
    const bool done = m_macroB ? m_macros.run(request) : m_oWords.run(request);
    if (request.kind == FlowRequest::Kind::modalMacro || request.kind == FlowRequest::Kind::cancelModal)
        m_state.modalMacro = request.kind == FlowRequest::Kind::modalMacro;
    if (m_macroB && request.kind != FlowRequest::Kind::none)
        updateProgramNumber();
    return done;
}

bool FlowRunner::leaveText() {
    // The call may be on the last line as well.
    while (m_calls.atEnd()) {
        if (m_calls.inMainProgram())
            return false;
        m_reporter.report(nc_message::kSubEndMissing, 1, 0, {m_calls.level().label});
        m_calls.leave();
    }
    return true;
}

/// What a failed action would have moved is unknown. Modes saved by M73 in a subprogram are restored at its
/// end.
void FlowRunner::execute(const std::function<bool()>& order) {
    const std::size_t level = m_calls.depth();
    const std::uint64_t endedRuns = m_calls.endedRuns();
    const std::uint32_t line = m_calls.mainLineNumber();
    if (!order())
        forgetAxes(m_state, LetterSet("XYZ"), Forgotten::reported);
    if (m_calls.endedRuns() == endedRuns)
        return;
    if (const auto saved = m_saves.endRun(level))
        m_blocks.restore(*saved, line);
}

/// LinuxCNC accepts M98 only at the beginning of a block, and M99 only alone in it; but M99 of the main
/// program anywhere.
void FlowRunner::checkPlaceOfCall(const Line& line, const FlowRequest& request) {
    if (m_dialect.macros != MacroLanguage::oWords)
        return;
    const Place& late = line.lateCall;
    if (request.kind == FlowRequest::Kind::call && late.column > 0)
        m_reporter.report(nc_message::kCallNotFirst, late.column, late.length, {"M98"});
    const bool alone = late.column == 0 && line.block.letters().empty() && line.block.codes().size() == 1;
    if (request.kind == FlowRequest::Kind::returns && !m_calls.inMainProgram() && !alone)
        m_reporter.report(nc_message::kReturnNotAlone, request.word);
}

/// This line always jumps elsewhere. A line that block delete may skip does not.
void FlowRunner::noteLeaving(const Line& line) {
    if (m_calls.inMainText() && !line.deleteMark)
        m_unreachable.leaves(m_calls.at());
}

/// Updates the number of the program that is running. A local subprogram has no number of its own.
void FlowRunner::updateProgramNumber() {
    if (m_calls.inMainProgram()) {
        m_state.programNumber = m_read.mainNumber;
        return;
    }
    const std::string& label = m_calls.level().label;
    int number = 0;
    if (std::from_chars(label.data(), label.data() + label.size(), number).ec == std::errc())
        m_state.programNumber = number;
}

} // namespace proveout
