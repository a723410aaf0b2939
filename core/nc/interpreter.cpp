// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/interpreter.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <span>

#include "core/nc/call_stack.h"
#include "core/nc/characters.h"
#include "core/nc/control_state.h"
#include "core/nc/dialect_guess.h"
#include "core/nc/execution.h"
#include "core/nc/expression_rules.h"
#include "core/nc/lexer.h"
#include "core/nc/lint.h"
#include "core/nc/machine_values.h"
#include "core/nc/macro_flow.h"
#include "core/nc/macro_variables.h"
#include "core/nc/motion_building.h"
#include "core/nc/o_word_flow.h"

namespace proveout {

namespace {

constexpr std::size_t kLongestLine = 252;   ///< characters that LinuxCNC reads
constexpr std::size_t kLinesPerLook = 1024; ///< lines between two looks at the stop token
constexpr std::size_t kLinesPerTell = 65536;

constexpr std::size_t kLongestShown = 40;        ///< bytes of a line in a message
constexpr std::uint8_t kContinuationMask = 0xc0; ///< of a byte within a character of UTF-8
constexpr std::uint8_t kContinuation = 0x80;

/// A part of a line for a message: not longer than is readable, cut between characters; a byte that no font
/// can show appears as its number.
std::string readable(std::string_view text) {
    if (text.size() == 1) {
        const auto byte = static_cast<unsigned char>(text.front());
        return byte < 0x20 || byte >= 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(text);
    }
    std::size_t end = std::min(text.size(), kLongestShown);
    while (end > 0 && end < text.size() &&
           (static_cast<unsigned char>(text[end]) & kContinuationMask) == kContinuation)
        --end;
    return std::string(text.substr(0, end));
}

class Interpreter {
public:
    Interpreter(const NcText& text, const InterpretOptions& options, const WorkContext& context)
        : m_text(text), m_options(options),
          m_guess(options.dialect ? DialectGuess{*options.dialect, {}} : guessDialect(text)),
          m_dialect(dialect(m_guess.dialect)), m_codes(codesOf(m_guess.dialect)), m_context(context),
          m_program(std::make_shared<Program>()),
          m_reporter(*m_program, options.file, options.maxDiagnostics), m_tools(options.tools),
          m_calls(text, options.file, {options.maxSteps, options.subprogramFolders, m_dialect.deepestCalls},
                  m_parameters, m_reporter) {
        if (options.start || options.assumeStartAtZero) {
            m_state.position = options.start.value_or(Vec3(0));
            m_state.known = kAllAxes;
        }
        m_state.machineZeroKnown = options.assumeStartAtZero;
        m_state.retractToR = m_dialect.retractsToR;
        if (m_dialect.beginsInRapid)
            m_state.motion = m_codes.find('G', 0);
    }

    std::shared_ptr<const Program> run() {
        const std::size_t count = m_text.lineCount();
        m_loneCr = m_text.firstLoneCr();
        m_program->setDialect(m_dialect.id);
        if (!m_guess.reasons.empty())
            tellGuess();
        if (m_macroB)
            skipToPercent();
        while (!m_finished && m_program->blockCount() < m_options.stopAfterBlocks &&
               (!m_calls.atEnd() || leaveText())) {
            if (!lookUp(count) || !m_calls.step())
                m_finished = m_cutShort = true;
            else
                runWatched();
        }
        if (m_linesRead == count)
            m_reporter.beginLine(static_cast<std::uint32_t>(count));
        m_program->settle();
        ControlState state = describe(m_state, m_parameters, m_calls, m_codes, m_dialect);
        state.line = m_steps == 0 ? 0 : static_cast<std::uint32_t>(m_calls.mainLine() + 1);
        m_program->setControlState(std::move(state));
        if (!m_cutShort && m_program->blockCount() < m_options.stopAfterBlocks)
            tellAboutTheWhole(m_linesRead);
        m_reporter.tellSuppressed();
        m_program->setSourceBlockCount(m_sourceBlocks);
        m_program->setAsksForTools(m_tools.asked());
        m_context.tell(1);
        return std::move(m_program);
    }

private:
    void tellGuess() {
        constexpr std::size_t kMostShown = 4;
        m_reporter.beginLine(1);
        std::string reasons;
        const std::span signs(m_guess.reasons);
        for (const DialectSign& sign : signs.first(std::min(signs.size(), kMostShown)))
            reasons += fmt::format("{}{} ({})", reasons.empty() ? "" : ", ", sign.shown, sign.line);
        m_reporter.tell(nc_message::kDialectGuessed, 1, 0, {m_dialect.name, reasons});
    }

    /// Controls of custom macro B's dialect look for the first "%" and read from there.
    void skipToPercent() {
        constexpr std::size_t kFarthest = 1000; ///< lines of a heading
        const std::size_t most = std::min(m_text.lineCount(), kFarthest);
        bool text = false;
        for (std::size_t line = 0; line < most; ++line) {
            const std::string_view content = m_text.line(line);
            const std::size_t at = skipBlanks(content, 0);
            if (at >= content.size())
                continue;
            if (content[at] != '%') {
                text = true;
                continue;
            }
            if (text) {
                m_reporter.beginLine(1);
                m_reporter.tell(nc_message::kTextBeforePercent, 1, 0);
                m_calls.jump(line);
            }
            return;
        }
    }

    /// Once in many lines: whether to stop, and how far it is. False where it has to stop.
    bool lookUp(std::size_t count) {
        m_reporter.beginLine(static_cast<std::uint32_t>(m_calls.line() + 1));
        const std::size_t step = m_steps++;
        if (step % kLinesPerLook == 0 && m_context.stopped()) {
            m_reporter.tellInAnyCase(nc_message::kStopped, 1, 0);
            return false;
        }
        if (step % kLinesPerTell == 0)
            m_context.tell(static_cast<double>(m_linesRead) / static_cast<double>(count));
        return true;
    }

    /// What is told about a line of the main text when it is reached first.
    void firstLook(std::size_t index, std::string_view text) {
        m_linesRead = index + 1;
        if (index == 0 && m_text.hadByteOrderMark())
            m_reporter.tell(nc_message::kByteOrderMark, 1, 0);
        if (index == m_loneCr)
            m_reporter.tell(nc_message::kLoneCr, static_cast<int>(text.size() + 1), 1);
    }

    /// A loop whose condition never changes, because a line of it cannot be read, does not run to the limit.
    void runWatched() {
        constexpr std::size_t kMostAgain = 10'000;
        const bool again = m_calls.at() < m_linesRead;
        const std::size_t told = m_reporter.count();
        runLine();
        m_toldAgain += again && m_reporter.count() > told ? 1 : 0;
        if (m_toldAgain < kMostAgain || m_finished)
            return;
        m_reporter.tellInAnyCase(nc_message::kTooManyAgain, 1, 0, {std::to_string(kMostAgain)});
        m_finished = m_cutShort = true;
    }

    void runLine() {
        const std::size_t index = m_calls.at();
        const std::string_view text = m_calls.text().line(index);
        const bool first = m_calls.inMainText() && index >= m_linesRead;
        if (first)
            firstLook(index, text);
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
            m_state.programNumber = m_mainNumber = m_line.program;
        if (m_line.flow)
            runFlow(first);
        else if (m_line.statement)
            runStatement(*m_line.statement, first);
        else if (!m_line.block.empty() || !m_line.assignments.empty())
            runBlock(first);
    }

    /// Whether an O-word begins the program that runs; another one is the end of it.
    bool beginsProgram(std::size_t index) {
        const bool begins = m_calls.inMainProgram() ? m_sourceBlocks == 0 : index == m_calls.level().entry;
        if (!begins)
            m_calls.endText();
        return begins;
    }

    /// At the end of a text or program: back to the caller; false in the main program.
    bool leaveText() {
        // The call may stand on the last line as well.
        while (m_calls.atEnd()) {
            if (m_calls.inMainProgram())
                return false;
            m_reporter.tell(nc_message::kSubEndMissing, 1, 0, {m_calls.level().label});
            m_calls.leave();
        }
        return true;
    }

    void runStatement(const MacroStatement& statement, bool first) {
        m_sourceBlocks += first ? 1 : 0;
        const MacroFlow::Next next = m_macros.run(statement);
        if (next == MacroFlow::Next::failed)
            m_state.forget(LetterSet("XYZ"));
        if (next != MacroFlow::Next::rest)
            return;
        const std::string_view text = m_calls.currentText();
        readRest(text, m_macros.rest(), m_readContext, m_line);
        if (m_line.error)
            skipUnreadable(text, false);
        else if (!m_line.block.empty() || !m_line.assignments.empty())
            runBlock(false);
    }

    bool runRequest(const FlowRequest& request) {
        const bool done = m_macroB ? m_macros.run(request) : m_oWords.run(request);
        if (m_macroB && request.kind != FlowRequest::Kind::none)
            noteProgram();
        return done;
    }

    /// The number of the program that runs now. A local subprogram has none of its own.
    void noteProgram() {
        if (m_calls.inMainProgram()) {
            m_state.programNumber = m_mainNumber;
            return;
        }
        const std::string& label = m_calls.level().label;
        int number = 0;
        if (std::from_chars(label.data(), label.data() + label.size(), number).ec == std::errc())
            m_state.programNumber = number;
    }

    void runFlow(bool first) {
        m_sourceBlocks += first ? 1 : 0;
        carryOut([&] { return m_oWords.run(*m_line.flow); });
        tellInputRead();
    }

    /// From here on the program depends on what only the machine has.
    void tellInputRead() {
        if (!m_values.takeInputRead() || !m_state.inputAssumed)
            return;
        m_state.inputAssumed = false;
        m_reporter.tell(nc_message::kInputUsed, 1, 0);
    }

    /// An order of the flow of the program; nobody knows what a failed one would have moved.
    template<typename Order>
    void carryOut(const Order& order) {
        const std::size_t level = m_calls.depth();
        const std::uint64_t endedRuns = m_calls.endedRuns();
        const std::size_t line = m_calls.mainLine() + 1;
        if (!order())
            m_state.forget(LetterSet("XYZ"));
        if (m_calls.endedRuns() != endedRuns)
            restoreAfter(level, static_cast<std::uint32_t>(line));
    }

    /// What M73 saved in a subprogram comes back at its end.
    void restoreAfter(std::size_t level, std::uint32_t line) {
        const auto saved = m_saves.endRun(level);
        if (!saved)
            return;
        FlowRequest none;
        const Block empty;
        Execution execution = executionOf(empty, none);
        execution.line = line; // the caller's, where the subprogram has a file of its own
        restore(execution, *saved, Word{'M', 72, 1, 0});
    }

    Execution executionOf(const Block& block, FlowRequest& request) {
        return {m_dialect,
                m_codes,
                block,
                m_state,
                m_parameters,
                m_tools,
                m_registers,
                request,
                *m_program,
                m_reporter,
                m_saves,
                m_splines,
                m_options.lint ? &m_lint : nullptr,
                m_calls.depth(),
                static_cast<std::uint32_t>(m_calls.mainLine() + 1),
                m_options.maxMotions,
                m_context};
    }

    /// From G10 L50 to G11 the blocks are data for the control.
    bool isData() {
        if (!m_state.dataInput)
            return false;
        constexpr double kEnd = 11;
        for (const Word& word : m_line.block.codes())
            m_state.dataInput = m_state.dataInput && (word.letter != 'G' || word.value != kEnd);
        return true;
    }

    void runBlock(bool first) {
        m_sourceBlocks += first ? 1 : 0;
        if (isData())
            return;
        assign();
        if (m_line.block.empty())
            return;
        FlowRequest request;
        Execution execution = executionOf(m_line.block, request);
        const std::size_t before = m_program->motionCount();
        executeBlock(execution);
        if (m_line.blockNumber)
            m_state.blockNumber = *m_line.blockNumber;
        const bool moved = m_program->motionCount() > before;
        const bool returns = request.kind == FlowRequest::Kind::returns && request.program == 0;
        if (returns && m_calls.inMainProgram())
            endAtReturn(execution, request.word);
        else if (request.kind != FlowRequest::Kind::none)
            carryOut([&] { return runRequest(request); });
        if (moved && m_macroB && !m_macros.afterMotion())
            m_state.forget(LetterSet("XYZ"));
        m_finished = m_state.ended || tooLong();
    }

    /// A control would start the program again; once is what there is to see.
    void endAtReturn(Execution& execution, const Word& word) {
        finishCompensated(execution, word);
        m_reporter.tell(nc_message::kMainReturn, word);
        m_program->append(ProgramEnd{}, static_cast<std::uint32_t>(m_calls.mainLine() + 1));
        m_state.ended = true;
    }

    /// What writing a system variable of custom macro B does besides; true where it is stored nowhere.
    bool writeVariable(const Assignment& order) {
        const std::string shown = fmt::format("#{}", order.target.number);
        switch (m_variables.writing(order.target.number)) {
        case MacroVariables::Writing::stored:
            return false;
        case MacroVariables::Writing::ignored:
            return true;
        case MacroVariables::Writing::offset:
            m_variables.write(order.target.number, isNull(order.value) ? 0 : order.value, *m_program,
                              static_cast<std::uint32_t>(m_calls.mainLine() + 1));
            return true;
        case MacroVariables::Writing::readOnly:
            m_reporter.tell(nc_message::kParameterReadOnly, order.column, order.length, {shown});
            return true;
        case MacroVariables::Writing::alarm:
            m_reporter.tell(nc_message::kAlarm, order.column, order.length,
                            {fmt::format("{:g}", order.value)});
            m_state.ended = m_finished = true;
            return true;
        case MacroVariables::Writing::stop:
            m_program->append(ProgramStop{StopKind::program},
                              static_cast<std::uint32_t>(m_calls.mainLine() + 1));
            return true;
        }
        return true;
    }

    void assign() {
        for (const Assignment& order : m_line.assignments) {
            const std::string& name = order.target.name;
            if (m_macroB && writeVariable(order))
                continue;
            if (!m_macroB && name.empty() && order.target.number == kInputParameter)
                m_state.inputAssumed = false;
            const bool readOnly = name.empty() ? m_system.numbered(order.target.number).has_value()
                                               : m_system.named(name).has_value();
            const std::string shown =
                name.empty() ? fmt::format("#{}", order.target.number) : fmt::format("#<{}>", name);
            if (readOnly)
                m_reporter.tell(nc_message::kParameterReadOnly, order.column, order.length, {shown});
            else if (name.empty())
                m_parameters.setNumbered(order.target.number, order.value);
            else if (!m_parameters.setNamed(name, order.value))
                m_reporter.tell(nc_message::kNamesTooMany, order.column, order.length, {shown});
        }
    }

    void tellAboutLine(std::string_view text) {
        if (!m_macroB && text.size() > kLongestLine)
            m_reporter.tell(nc_message::kLineLong, kLongestLine + 1, 1, {std::to_string(text.size())});
        if (m_line.controlCodeColumn > 0 && !m_controlCodeTold) {
            m_controlCodeTold = true;
            m_reporter.tell(nc_message::kControlCode, m_line.controlCodeColumn, 1);
        }
        if (m_line.longBlockNumber.column > 0 && !m_longNumberTold) {
            m_longNumberTold = true;
            m_reporter.tell(nc_message::kBlockNumberLong, m_line.longBlockNumber.column,
                            m_line.longBlockNumber.length);
        }
    }

    /// What the line orders is not known, so the axes that it names may be anywhere afterwards.
    void skipUnreadable(std::string_view text, bool first) {
        const ReadError& error = *m_line.error;
        m_reporter.tell(*error.message, error.column, error.length, {readable(error.argument)});
        m_sourceBlocks += first ? 1 : 0;
        m_state.forget(axisLetters(text));
    }

    /// LinuxCNC runs what is between two "%". One alone is forgiven at the end of the file.
    void handlePercent(std::size_t index) {
        if (!m_percentOpen && m_sourceBlocks == 0) {
            m_percentOpen = true;
        } else if (m_percentOpen) {
            m_percentClosed = true;
            m_finished = true;
        } else if (firstTextFrom(index + 1) == m_text.lineCount()) {
            m_reporter.tell(nc_message::kPercentUnpaired, 1, 1);
            m_percentClosed = true;
            m_finished = true;
        } else {
            m_reporter.tell(nc_message::kPercentInside, 1, 1);
        }
    }

    /// The first line from `index` on that holds anything; the number of lines where there is none.
    [[nodiscard]] std::size_t firstTextFrom(std::size_t index) const {
        while (index < m_text.lineCount() &&
               m_text.line(index).find_first_not_of(" \t\v\f\x1a%") == std::string_view::npos)
            ++index;
        return index;
    }

    bool tooLong() {
        const bool motions = m_program->motionCount() > m_options.maxMotions;
        if (!motions && m_program->events().size() <= m_options.maxMotions)
            return false;
        m_reporter.tellInAnyCase(motions ? nc_message::kTooManyMotions : nc_message::kTooManyEvents, 1, 0,
                                 {std::to_string(m_options.maxMotions)});
        m_cutShort = true;
        return true;
    }

    void tellAboutTheWhole(std::size_t linesRead) {
        if (m_state.compensation.on)
            m_reporter.tellInAnyCase(nc_message::kCompensationAtEnd, 1, 0);
        if (!m_splines.nurbs.points.empty())
            m_reporter.tellInAnyCase(nc_message::kNurbsOpen, 1, 0);
        const std::size_t rest = firstTextFrom(linesRead);
        if ((m_state.ended || m_percentClosed) && rest < m_text.lineCount()) {
            m_reporter.beginLine(static_cast<std::uint32_t>(rest + 1));
            m_reporter.tellInAnyCase(m_state.ended ? nc_message::kAfterEnd : nc_message::kAfterPercent, 1, 0);
        }
        if (m_program->motionCount() == 0)
            m_reporter.tellInAnyCase(nc_message::kNoMotion, 1, 0);
        else if (!m_state.ended && !m_percentClosed)
            m_reporter.tellInAnyCase(nc_message::kNoProgramEnd, 1, 0);
        tellNeverKnown();
    }

    /// Axes without which a motion cut nothing were told there.
    void tellNeverKnown() {
        const auto never = static_cast<std::uint8_t>(kAllAxes & ~(m_state.everKnown | m_state.unknownTold));
        if (never != 0 && m_program->motionCount() > 0 && !m_options.assumeStartAtZero)
            m_reporter.tellInAnyCase(nc_message::kNeverKnown, 1, 0, {namesOfAxes(never)});
    }

    const NcText& m_text;
    const InterpretOptions& m_options;
    const DialectGuess m_guess;
    const Dialect& m_dialect;
    const bool m_macroB = m_dialect.macros == MacroLanguage::macroB;
    const CodeTable& m_codes;
    const WorkContext& m_context;
    std::shared_ptr<Program> m_program;
    Reporter m_reporter;
    MachineState m_state;
    Parameters m_parameters{m_dialect.macros};
    ToolOffsets m_tools;
    OffsetRegisters m_registers{m_tools, m_dialect.registersHoldDiameter};
    ModalSaves m_saves;
    SplineState m_splines;
    MachineValues m_values{m_state};
    MacroVariables m_variables{m_state, m_parameters, m_registers, m_dialect};
    const SystemValues& m_system = m_macroB ? static_cast<const SystemValues&>(m_variables) : m_values;
    ReadContext m_readContext{m_parameters, m_system, m_dialect, m_options.blockDelete};
    CallStack m_calls;
    OWordFlow m_oWords{m_calls, m_parameters, m_readContext, m_reporter};
    MacroFlow m_macros{m_calls, m_readContext, m_reporter};
    LintMemory m_lint;
    Line m_line;
    std::size_t m_loneCr = 0;
    std::size_t m_linesRead = 0; ///< of the main text, counted to the last one that was reached
    std::size_t m_steps = 0;
    std::size_t m_toldAgain = 0; ///< lines that were told about though they had run before
    std::size_t m_sourceBlocks = 0;
    double m_mainNumber = 0; ///< O of the main program
    bool m_percentOpen = false;
    bool m_percentClosed = false;
    bool m_finished = false;
    bool m_cutShort = false; ///< stopped, or at a limit: what the rest of the program says is not known
    bool m_controlCodeTold = false;
    bool m_longNumberTold = false;
};

} // namespace

std::shared_ptr<const Program> interpret(const NcText& text, const InterpretOptions& options,
                                         const WorkContext& context) {
    return Interpreter(text, options, context).run();
}

} // namespace proveout
