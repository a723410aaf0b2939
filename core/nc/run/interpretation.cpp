// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/interpretation.h"

#include "core/nc/codes/dialects.h"
#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include "core/nc/run/control_description.h"

namespace proveout {

namespace {

constexpr std::size_t kLinesPerLook = 1024; ///< lines between two looks at the stop token
constexpr std::size_t kLinesPerTell = 65536;

/// The row of the table with what the builder of the machine set.
Dialect configured(DialectId id, const InterpretOptions& options) {
    Dialect result = dialect(id);
    result.vectors.typeB = options.compensationTypeB;
    return result;
}

} // namespace

Interpretation::Interpretation(const NcText& text, const InterpretOptions& options, DialectGuess guess,
                               const WorkContext& context)
    : m_text(text), m_options(options), m_guess(std::move(guess)),
      m_dialect(configured(m_guess.dialect, options)), m_codes(codesOf(m_guess.dialect)), m_context(context),
      m_program(std::make_shared<Program>()),
      m_reporter(*m_program, options.file, options.maxDiagnostics, m_dialect.answer),
      m_run(m_dialect.macros, options.tools),
      m_calls(text, options.file, {options.subprogramFolders, m_dialect.deepestCalls}, m_parameters,
              m_reporter) {
    if (options.start || options.assumeStartAtZero) {
        m_state.position = options.start.value_or(Vec3(0));
        m_state.known = kAllAxes;
    }
    m_state.tool = options.startTool;
    m_state.machineZeroKnown = options.assumeStartAtZero;
    m_state.retractToR = m_dialect.retractsToR;
    if (m_dialect.beginsInRapid)
        m_state.motion = m_codes.find('G', 0);
}

std::shared_ptr<const Program> Interpretation::run() {
    m_loneCr = m_text.firstLoneCr();
    if (!m_begun)
        begin();
    while (!m_finished && m_program->blockCount() < m_options.stopAfterBlocks &&
           (!m_calls.atEnd() || leaveText())) {
        if (m_calls.line() >= m_nextPoint)
            offerPoint();
        if (lookUp())
            runCounted();
        else
            m_finished = m_cutShort = true;
    }
    end();
    return std::move(m_program);
}

void Interpretation::goOn(const ResumePoint& point, const Program& earlier) {
    m_begun = true;
    *m_program = Program(earlier, point.program);
    m_reporter.restore(point.told);
    m_run = point.run;
    m_registers.restore(point.registers);
    m_calls.goOn(point.calls);
}

void Interpretation::keepPoints(std::size_t firstLine, KeepPoint keep) {
    m_nextPoint = firstLine;
    m_keepPoint = std::move(keep);
}

/// Where nothing is under way that a value could not hold.
void Interpretation::offerPoint() {
    auto place = m_calls.place();
    if (!place || m_macros.modal() || !m_program->settled())
        return;
    // A jump has looked at the line that it leads to.
    const std::size_t seen = place->line + (place->indexAsked ? 1 : 0);
    m_run.linesSeen = std::max({m_run.linesSeen, m_run.linesRead, seen});
    m_nextPoint = m_keepPoint(
        {m_run, m_registers.contents(), std::move(*place), m_reporter.memory(), m_program->extent()},
        *m_program);
}

void Interpretation::begin() {
    m_program->setDialect(m_dialect.id);
    m_program->expect(m_text.lineCount());
    if (!m_guess.reasons.empty())
        tellGuess();
    tellListedButExecuted();
    if (m_macroB)
        skipToPercent();
}

void Interpretation::end() {
    if (m_run.linesRead == m_text.lineCount())
        m_reporter.beginLine(static_cast<std::uint32_t>(m_text.lineCount()));
    m_program->settle();
    ControlState state = describe(m_state, m_parameters, m_calls, m_codes, m_dialect);
    state.line = m_run.steps == 0 ? 0 : mainLine();
    m_program->setControlState(std::move(state));
    if (!m_cutShort && m_program->blockCount() < m_options.stopAfterBlocks)
        tellAboutTheWhole(m_run.linesRead);
    const std::uint32_t last = m_reporter.line();
    tellIgnored();
    m_program->setIgnoredCodes(m_run.ignored);
    m_reporter.beginLine(last);
    m_reporter.tellSuppressed();
    m_program->setSourceBlockCount(m_run.sourceBlocks);
    m_program->setAsksForTools(m_run.tools.asked());
    m_program->setAsksForStock(m_state.probed.asked);
    m_program->setRunsAgain(m_run.runsAgain);
    if (m_watch.active())
        m_program->setLineValues(std::make_shared<const LineValues>(m_watch.values()));
    m_context.tell(1);
}

/// Once in many lines: whether to stop, and how far it is. False where it has to stop.
bool Interpretation::lookUp() {
    m_reporter.beginLine(static_cast<std::uint32_t>(m_calls.line() + 1));
    const std::size_t step = m_run.steps++;
    if (step % kLinesPerLook == 0 && m_context.stopped()) {
        m_reporter.tellInAnyCase(nc_message::kStopped, 1, 0, {m_calls.linesOfCalls()});
        return false;
    }
    if (step % kLinesPerTell == 0)
        m_context.tell(static_cast<double>(m_run.linesRead) / static_cast<double>(m_text.lineCount()));
    return true;
}

/// A line, unless the program has come back to it once too often.
void Interpretation::runCounted() {
    Repetition& repetition = m_run.repetition;
    m_calls.step();
    if (repeatsTooMuch() || goesRoundForGood()) {
        m_finished = m_cutShort = true;
        return;
    }
    repetition.begin(m_calls.isAgain(), *m_program);
    const std::size_t at = m_calls.at();
    const std::size_t length = m_calls.currentText().size();
    const std::size_t told = m_reporter.count();
    runWatched();
    // What was told once may be done otherwise the next time.
    if (m_system.takeUse() || m_macros.modal() || m_state.dataInput || m_reporter.count() > told)
        repetition.noteUse();
    repetition.leftTo(m_calls.takeLowestDepth());
    repetition.end(length, m_calls.line() <= at ? std::optional(at) : std::nullopt, *m_program);
}

/// Loops and calls have limits, beyond which nobody waits for their end.
bool Interpretation::repeatsTooMuch() {
    constexpr std::uint64_t kOfLine = 10;
    const std::uint64_t ofText = kOfLine * m_text.lineCount();
    const Repetition::Limits limits{std::max(m_options.maxRepeated, ofText),
                                    std::max(m_options.maxIdle, ofText)};
    const Repetition::Verdict verdict = m_run.repetition.verdict(limits);
    if (verdict == Repetition::Verdict::goesOn)
        return false;
    const bool idle = verdict == Repetition::Verdict::idle;
    m_program->cutBack(m_run.repetition.before());
    m_reporter.tellInAnyCase(idle ? nc_message::kIdleLoop : nc_message::kTooMuchRepeated, 1, 0,
                             {std::to_string(idle ? limits.idle : limits.work), m_calls.linesOfCalls()});
    return true;
}

/// Whether it is proved that the program never leaves the loop of this line.
bool Interpretation::goesRoundForGood() {
    const auto from = m_run.repetition.jumpedFrom();
    if (!from)
        return false;
    const Repetition::Head head{m_calls.source().number, m_calls.at(), m_calls.depth(),
                                m_parameters.changes() + m_calls.roundsCounted()};
    if (!m_run.repetition.closes(head, *m_program))
        return false;
    m_program->cutBack(m_run.repetition.firstRound());
    m_reporter.tellInAnyCase(nc_message::kEndlessLoop, 1, 0,
                             {std::to_string(*from + 1), std::to_string(m_calls.at() + 1)});
    return true;
}

/// A loop whose condition never changes, because a line of it cannot be read, does not run to the limit.
void Interpretation::runWatched() {
    constexpr std::size_t kMostAgain = 10'000;
    const bool again = m_calls.at() < m_run.linesRead;
    const std::size_t told = m_reporter.count();
    m_run.runsAgain = m_run.runsAgain || again;
    if (m_calls.inMainText() && m_watch.watches(m_calls.at()))
        runLineWatched();
    else
        runLine();
    m_run.toldAgain += again && m_reporter.count() > told ? 1 : 0;
    if (m_run.toldAgain < kMostAgain || m_finished)
        return;
    m_reporter.tellInAnyCase(nc_message::kTooManyAgain, 1, 0, {std::to_string(kMostAgain)});
    m_finished = m_cutShort = true;
}

void Interpretation::runLineWatched() {
    const std::string_view text = m_calls.text().line(m_calls.at());
    const auto modes = [&] { return describe(m_state, m_parameters, m_calls, m_codes, m_dialect).modes; };
    // To look at a value is no use of it by the program.
    const auto forgetReads = [&] {
        (void)m_values.takeInputRead();
        (void)m_system.takeProbeRead();
    };
    m_watch.begin(text, m_readContext, modes());
    forgetReads();
    runLine();
    m_watch.end(m_line, text, m_readContext, m_state, modes());
    forgetReads();
    if (!m_options.watchToEnd)
        m_finished = m_cutShort = true;
}

void Interpretation::runLine() {
    const std::size_t index = m_calls.at();
    std::string_view text = m_calls.text().line(index);
    const bool first = m_calls.inMainText() && index >= m_run.linesRead;
    if (first)
        firstLook(index, text);
    if (m_dialect.streamed && !readStreamed(text, first))
        return;
    readLine(text, m_readContext, m_line);
    if (m_line.deleteMark && m_options.blockDelete)
        return;
    tellInputRead();
    if (first)
        tellAboutLine(text);
    if (m_line.error) {
        skipUnreadable(text, first);
        return;
    }
    if (m_line.percent) {
        if (m_calls.inMainText())
            handlePercent(index);
        else if (m_macroB && index > 0)
            m_calls.endText();
        return;
    }
    if (m_line.programNumber && !beginsProgram(index))
        return;
    if (m_line.programNumber && m_calls.inMainProgram())
        m_state.programNumber = m_run.mainNumber = m_line.program;
    if (m_line.flow)
        runFlow(first);
    else if (m_line.statement)
        runStatement(*m_line.statement, first);
    else if (!m_line.block.empty() || !m_line.assignments.empty())
        runBlock(first);
}

void Interpretation::runStatement(const MacroStatement& statement, bool first) {
    m_run.sourceBlocks += first ? 1 : 0;
    if (statement.kind == StatementKind::gotoBlock)
        noteLeaving();
    const MacroFlow::Next next = m_macros.run(statement);
    tellInputRead();
    if (next == MacroFlow::Next::failed)
        m_state.forget(LetterSet("XYZ"), Forgotten::reported);
    if (next != MacroFlow::Next::rest)
        return;
    const std::string_view text = m_calls.currentText();
    readRest(text, m_macros.rest(), m_readContext, m_line);
    tellInputRead();
    if (m_line.error)
        skipUnreadable(text, false);
    else if (!m_line.block.empty() || !m_line.assignments.empty())
        runBlock(false);
}

bool Interpretation::runRequest(const FlowRequest& request) {
    const bool done = m_macroB ? m_macros.run(request) : m_oWords.run(request);
    if (request.kind == FlowRequest::Kind::modalMacro || request.kind == FlowRequest::Kind::cancelModal)
        m_state.modalMacro = request.kind == FlowRequest::Kind::modalMacro;
    if (m_macroB && request.kind != FlowRequest::Kind::none)
        noteProgram();
    return done;
}

void Interpretation::runFlow(bool first) {
    m_run.sourceBlocks += first ? 1 : 0;
    if (m_line.flow->kind == FlowKind::returns)
        noteLeaving();
    carryOut([&] { return m_oWords.run(*m_line.flow); });
    tellInputRead();
}

/// This line always leads elsewhere. One that block delete may skip does not.
void Interpretation::noteLeaving() {
    if (m_calls.inMainText() && !m_line.deleteMark)
        m_run.unreachable.leaves(m_calls.at());
}

/// At the end of a text or program: back to the caller; false in the main program.
bool Interpretation::leaveText() {
    // The call may stand on the last line as well.
    while (m_calls.atEnd()) {
        if (m_calls.inMainProgram())
            return false;
        m_reporter.tell(nc_message::kSubEndMissing, 1, 0, {m_calls.level().label});
        m_calls.leave();
    }
    return true;
}

/// The number of the program that runs now. A local subprogram has none of its own.
void Interpretation::noteProgram() {
    if (m_calls.inMainProgram()) {
        m_state.programNumber = m_run.mainNumber;
        return;
    }
    const std::string& label = m_calls.level().label;
    int number = 0;
    if (std::from_chars(label.data(), label.data() + label.size(), number).ec == std::errc())
        m_state.programNumber = number;
}

/// An order of the flow of the program; nobody knows what a failed one would have moved.
void Interpretation::carryOut(const std::function<bool()>& order) {
    const std::size_t level = m_calls.depth();
    const std::uint64_t endedRuns = m_calls.endedRuns();
    const std::size_t line = m_calls.mainLine() + 1;
    if (!order())
        m_state.forget(LetterSet("XYZ"), Forgotten::reported);
    if (m_calls.endedRuns() != endedRuns)
        restoreAfter(level, static_cast<std::uint32_t>(line));
}

/// What M73 saved in a subprogram comes back at its end.
void Interpretation::restoreAfter(std::size_t level, std::uint32_t line) {
    const auto saved = m_run.saves.endRun(level);
    if (!saved)
        return;
    FlowRequest none;
    const Block empty;
    Execution execution = executionOf(empty, none);
    execution.line = line; // the caller's, where the subprogram has a file of its own
    restore(execution, *saved, Word{'M', 72, 1, 0});
}

} // namespace proveout
