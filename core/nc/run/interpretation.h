// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "core/nc/codes/dialect_guess.h"
#include "core/nc/flow/call_stack.h"
#include "core/nc/flow/macro_flow.h"
#include "core/nc/flow/macro_variables.h"
#include "core/nc/flow/o_word_flow.h"
#include "core/nc/run/interpreter.h"
#include "core/nc/run/line_watch.h"
#include "core/nc/run/resume_point.h"
#include "core/nc/run/serial_line.h"
#include "core/nc/state/execution.h"
#include "core/nc/state/machine_values.h"
#include "core/nc/text/lexer.h"

namespace proveout {

/// One run through an NC text, line by line. Keeps references to its arguments.
class Interpretation {
public:
    Interpretation(const NcText& text, const InterpretOptions& options, DialectGuess guess,
                   const WorkContext& context);

    /// Instead of at the beginning: at a point of an earlier run, of which `earlier` is the result, or a
    /// longer program. The lines before it must be the same.
    void goOn(const ResumePoint& point, const Program& earlier);

    /// Is handed a point and the program so far; returns the line from which on it wants the next one.
    using KeepPoint = std::function<std::size_t(ResumePoint, const Program&)>;
    void keepPoints(std::size_t firstLine, KeepPoint keep);

    /// Once.
    [[nodiscard]] std::shared_ptr<const Program> run();

private:
    // Lines, one after the other: interpretation.cpp.
    void begin();
    void offerPoint();
    void end();
    bool lookUp();
    void runCounted();
    bool repeatsTooMuch();
    bool goesRoundForGood();
    void runWatched();
    void runLine();
    void runLineWatched();
    void runStatement(const MacroStatement& statement, bool first);
    bool runRequest(const FlowRequest& request);
    void runFlow(bool first);
    bool leaveText();
    void noteProgram();
    void noteLeaving();
    void carryOut(const std::function<bool()>& order);
    void restoreAfter(std::size_t level, std::uint32_t line);

    // Blocks and assignments: interpretation_blocks.cpp.
    void runBlock(bool first);
    bool isData();
    void checkPlaceOfCall(const FlowRequest& request);
    void endAtReturn(Execution& execution, const Word& word);
    void ignoreCodes();
    void assign();
    bool writeVariable(const Assignment& order);
    bool tooLong();
    Execution executionOf(const Block& block, FlowRequest& request);

    // The text as a whole, its first and its last lines: interpretation_text.cpp.
    void tellGuess();
    void tellListedButExecuted();
    void tellIgnored();
    void skipToPercent();
    bool beginsProgram(std::size_t index);
    void firstLook(std::size_t index, std::string_view text);
    bool readStreamed(std::string_view& text, bool first);
    void tellAboutLine(std::string_view text);
    void tellInputRead();
    void skipUnreadable(std::string_view text, bool first);
    void handlePercent(std::size_t index);
    [[nodiscard]] std::size_t firstTextFrom(std::size_t index);
    void tellAboutTheWhole(std::size_t linesRead);
    void tellNeverKnown();
    void tellUnseen();

    /// The line of the main text that is being carried out, or that called, 1-based.
    [[nodiscard]] std::uint32_t mainLine() const {
        return static_cast<std::uint32_t>(m_calls.mainLine() + 1);
    }

    [[nodiscard]] const SystemValues& systemValues() const;

    const NcText& m_text;
    const InterpretOptions& m_options;
    const DialectGuess m_guess;
    const Dialect m_dialect; ///< as the options set it
    const bool m_macroB = m_dialect.macros == MacroLanguage::macroB;
    const CodeTable& m_codes;
    const WorkContext& m_context;
    std::shared_ptr<Program> m_program;
    Reporter m_reporter;
    const std::unique_ptr<ProbeTarget> m_target = m_options.part.target();

    RunState m_run;
    MachineState& m_state = m_run.machine;
    Parameters& m_parameters = m_run.parameters;

    OffsetRegisters m_registers{m_run.tools, m_dialect.registersHoldDiameter};
    MachineValues m_values{m_state};
    MacroVariables m_variables{m_state, m_parameters, m_registers, m_dialect};
    OffsetValues m_offsetValues{m_state};
    const SystemValues& m_system = systemValues();
    ReadContext m_readContext{m_parameters, m_system, m_dialect, m_options.blockDelete};
    CallStack m_calls;
    OWordFlow m_oWords{m_calls, m_parameters, m_readContext, m_reporter};
    MacroFlow m_macros{m_calls, m_readContext, m_reporter, m_run.lint};
    SerialLine m_serial{m_dialect.longestLine};
    Line m_line;
    std::size_t m_loneCr = 0;
    /// Lines that are known to hold nothing: from the first on, before the second.
    std::pair<std::size_t, std::size_t> m_blankLines{0, 0};
    KeepPoint m_keepPoint;
    std::size_t m_nextPoint = SIZE_MAX; ///< line
    bool m_begun = false;
    LineWatch m_watch{m_options.watchedLine};
    bool m_finished = false;
    bool m_cutShort = false; ///< stopped, or at a limit: what the rest of the program says is not known
};

} // namespace proveout
