// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/interpretation.h"

#include <algorithm>
#include <utility>

#include "core/nc/codes/codes.h"
#include "core/nc/codes/dialects.h"

namespace proveout {

namespace {

constexpr std::size_t kLinesPerLook = 1024; ///< lines between two checks of the stop token
constexpr std::size_t kLinesPerReport = 65536;

/// The row of the table with the settings of the machine builder.
Dialect configured(DialectId id, const InterpretOptions& options) {
    Dialect result = dialect(id);
    result.vectors.typeB = options.compensationTypeB;
    return result;
}

/// Long texts may repeat more.
Repetition::Limits repetitionLimits(const NcText& text, const InterpretOptions& options) {
    constexpr std::uint64_t kOfLine = 10;
    const std::uint64_t ofText = kOfLine * text.lineCount();
    return {std::max(options.maxRepeated, ofText), std::max(options.maxIdle, ofText)};
}

} // namespace

Interpretation::Interpretation(const NcText& text, const InterpretOptions& options, DialectGuess guess,
                               const WorkContext& context)
    : m_text(text), m_options(options), m_context(context), m_dialect(configured(guess.dialect, options)),
      m_program(std::make_shared<Program>()),
      m_reporter(*m_program, options.file, options.maxDiagnostics, m_dialect.answer),
      m_run(m_dialect.macros, options.tools),
      m_calls(text, options.file, {options.subprogramFolders, m_dialect.deepestCalls},
              m_run.memory.parameters, m_reporter),
      m_lines(text, options, m_dialect, context, m_run, m_calls, *m_program, m_reporter),
      m_repeats(repetitionLimits(text, options), m_run.repeats, m_calls, m_run.memory.parameters, *m_program,
                m_reporter),
      m_notices(text, options, std::move(guess), m_dialect, m_run, *m_program, m_reporter) {
    MachineState& state = m_run.memory.machine;
    if (options.start || options.assumeStartAtZero) {
        state.position = options.start.value_or(Vec3(0));
        state.known = kAllAxes;
    }
    state.tool = options.startTool;
    state.machineZeroKnown = options.assumeStartAtZero;
    state.retractToR = m_dialect.retractsToR;
    if (m_dialect.beginsInRapid)
        state.motion = codesOf(m_dialect.id).find('G', 0);
}

std::shared_ptr<const Program> Interpretation::run() {
    if (!m_begun)
        begin();
    while (!isFinished() && m_program->blockCount() < m_options.stopAfterBlocks &&
           (!m_calls.atEnd() || m_lines.leaveText())) {
        if (m_calls.line() >= m_nextPoint)
            offerPoint();
        if (m_beginnings != nullptr && m_beginnings->isDue(*m_program))
            m_beginnings->publish(*m_program, m_calls.mainLineNumber(), m_run.read.sourceBlocks);
        m_cutShort = !lookUp() || !runLine();
    }
    end();
    return std::move(m_program);
}

void Interpretation::resume(const ResumePoint& point, const Program& earlier) {
    m_begun = true;
    *m_program = Program(earlier, point.program);
    m_reporter.restore(point.reported);
    m_run = point.run;
    m_lines.registers().restore(point.registers);
    m_calls.continueAt(point.calls);
}

void Interpretation::keepPoints(std::size_t firstLine, KeepPoint keep) {
    m_nextPoint = firstLine;
    m_keepPoint = std::move(keep);
}

/// Only if nothing is in progress that the point could not store.
void Interpretation::offerPoint() {
    auto place = m_calls.place();
    if (!place || m_lines.hasModalMacro() || !m_program->settled())
        return;
    // A jump has read the line that it leads to.
    const std::size_t seen = place->line + (place->indexAsked ? 1 : 0);
    m_run.read.linesSeen = std::max({m_run.read.linesSeen, m_run.read.linesRead, seen});
    m_nextPoint = m_keepPoint(
        {m_run, m_lines.registers().contents(), std::move(*place), m_reporter.memory(), m_program->extent()});
}

void Interpretation::begin() {
    m_program->setDialect(m_dialect.id);
    m_program->expect(m_text.lineCount());
    m_notices.reportBeginning();
    m_lines.begin();
}

void Interpretation::end() {
    if (m_run.read.linesRead == m_text.lineCount())
        m_reporter.beginLine(static_cast<std::uint32_t>(m_text.lineCount()));
    m_program->settle();
    ControlState state = m_lines.controlState();
    state.line = m_run.steps == 0 ? 0 : m_calls.mainLineNumber();
    m_program->setControlState(std::move(state));
    if (!m_cutShort && m_program->blockCount() < m_options.stopAfterBlocks)
        m_notices.reportEnd(m_lines.firstTextFrom(m_run.read.linesRead));
    const std::uint32_t last = m_reporter.line();
    m_notices.reportIgnoredCodes();
    m_program->setIgnoredCodes(m_run.ignored);
    m_reporter.beginLine(last);
    m_reporter.reportSuppressed();
    m_program->setSourceBlockCount(m_run.read.sourceBlocks);
    m_program->setAsksForTools(m_run.memory.tools.asked());
    m_program->setAsksForStock(m_run.memory.machine.probed.asked);
    m_program->setRunsAgain(m_run.repeats.runsAgain);
    if (m_lines.watch().active())
        m_program->setLineValues(std::make_shared<const LineValues>(m_lines.watch().values()));
    m_context.report(1);
}

/// Called once in many lines: checks whether to stop, and reports progress. False if it has to stop.
bool Interpretation::lookUp() {
    m_reporter.beginLine(static_cast<std::uint32_t>(m_calls.line() + 1));
    const std::size_t step = m_run.steps++;
    if (step % kLinesPerLook == 0 && m_context.stopped()) {
        m_reporter.reportInAnyCase(nc_message::kStopped, 1, 0, {m_calls.linesOfCalls()});
        return false;
    }
    if (step % kLinesPerReport == 0)
        m_context.report(static_cast<double>(m_run.read.linesRead) / static_cast<double>(m_text.lineCount()));
    return true;
}

/// Runs the next line. False if the program must not continue: it has come back to the line too often, or is
/// cut short there.
bool Interpretation::runLine() {
    m_calls.step();
    if (!m_repeats.mayRun())
        return false;
    m_program->beginLine(m_calls.inMainText() ? static_cast<std::uint32_t>(m_calls.at() + 1) : 0,
                         m_calls.depth());
    const RepeatGuard::Started started = m_repeats.begin(m_run.read.linesRead);
    const bool continues = m_lines.run();
    m_repeats.end(started, m_lines.consumeDependence());
    return continues && (isFinished() || !m_repeats.reportsTooOften());
}

} // namespace proveout
