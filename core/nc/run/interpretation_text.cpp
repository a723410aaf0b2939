// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fmt/format.h>
#include <span>

#include "core/base/utf8.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/run/interpretation.h"
#include "core/nc/run/skipped_block.h"
#include "core/nc/text/characters.h"

namespace proveout {

namespace {

constexpr std::size_t kLongestShown = 40; ///< bytes of a line in a message

/// A part of a line for a message: not longer than is readable, cut between characters; a byte that no font
/// can show appears as its number.
std::string readable(std::string_view text) {
    if (text.size() == 1) {
        const auto byte = static_cast<unsigned char>(text.front());
        return byte < 0x20 || byte >= 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(text);
    }
    return std::string(shortened(text, kLongestShown));
}

const Message& ignoredMessage(bool known, bool manyLines) {
    if (known)
        return manyLines ? nc_message::kCodeIgnoredInLines : nc_message::kCodeIgnored;
    return manyLines ? nc_message::kCodeIgnoredByListInLines : nc_message::kCodeIgnoredByList;
}

} // namespace

const SystemValues& Interpretation::systemValues() const {
    switch (m_dialect.macros) {
    case MacroLanguage::macroB:
        return m_variables;
    case MacroLanguage::labels:
    case MacroLanguage::none:
        return m_offsetValues;
    case MacroLanguage::oWords:
        break;
    }
    return m_values;
}

void Interpretation::tellGuess() {
    constexpr std::size_t kMostShown = 4;
    m_reporter.beginLine(1);
    std::string reasons;
    const std::span signs(m_guess.reasons);
    for (const DialectSign& sign : signs.first(std::min(signs.size(), kMostShown)))
        reasons += fmt::format("{}{} ({})", reasons.empty() ? "" : ", ", sign.shown, sign.line);
    m_reporter.tell(nc_message::kDialectGuessed, 1, 0, {m_dialect.name, reasons});
}

/// Codes that the list of ignored ones has, but that have an effect.
void Interpretation::tellListedButExecuted() {
    constexpr int kTenths = 10;
    m_reporter.beginLine(1);
    for (const int number : m_options.ignoredM) {
        const CodeRow* row = number < kLargestMCode / kTenths ? m_codes.find('M', number * kTenths) : nullptr;
        if (row != nullptr && row->handler != nullptr)
            m_reporter.tell(nc_message::kIgnoredExecuted, 1, 0, {fmt::format("M{}", number), row->name});
    }
}

/// One message a code, at the line where it was met first.
void Interpretation::tellIgnored() {
    for (const auto& [number, code] : m_run.ignored) {
        const bool known = *code.name != '\0';
        std::vector<std::string> arguments{fmt::format("M{}", number)};
        if (known)
            arguments.emplace_back(code.name);
        arguments.push_back(std::to_string(code.count));
        arguments.push_back(linesOf(code));
        m_reporter.beginLine(code.lines.front());
        m_reporter.tell(ignoredMessage(known, code.lines.size() > 1), code.column, code.length,
                        std::move(arguments));
    }
}

/// Controls of custom macro B's dialect look for the first "%" and read from there.
void Interpretation::skipToPercent() {
    constexpr std::size_t kFarthest = 1000; ///< lines of a heading
    const std::size_t most = std::min(m_text.lineCount(), kFarthest);
    m_run.linesSeen = kFarthest;
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
        m_run.linesSeen = line + 1;
        return;
    }
}

/// Whether an O-word begins the program that runs; another one is the end of it.
bool Interpretation::beginsProgram(std::size_t index) {
    const bool begins = m_calls.inMainProgram() ? m_run.sourceBlocks == 0 : index == m_calls.level().entry;
    if (!begins)
        m_calls.endText();
    return begins;
}

/// What is told about a line of the main text when it is reached first.
void Interpretation::firstLook(std::size_t index, std::string_view text) {
    m_run.linesRead = index + 1;
    if (index == 0 && m_text.hadByteOrderMark())
        m_reporter.tell(nc_message::kByteOrderMark, 1, 0);
    if (index == m_loneCr)
        m_reporter.tell(nc_message::kLoneCr, static_cast<int>(text.size() + 1), 1);
}

/// Leaves in `text` what the control on a serial line reads as a block; false where it reads none.
bool Interpretation::readStreamed(std::string_view& text, bool first) {
    const bool block = m_serial.read(text, m_run.serial, m_reporter, m_state);
    if (!block) {
        m_state.forget(axisLetters(text));
        m_run.sourceBlocks += first ? 1 : 0;
    }
    text = m_serial.text();
    return block;
}

void Interpretation::tellAboutLine(std::string_view text) {
    const std::size_t longest = m_dialect.streamed ? 0 : m_dialect.longestLine;
    if (longest > 0 && text.size() > longest)
        m_reporter.tell(nc_message::kLineLong, static_cast<int>(longest + 1), 1,
                        {std::to_string(text.size())});
    if (m_line.controlCodeColumn > 0 && !m_run.controlCodeTold) {
        m_run.controlCodeTold = true;
        m_reporter.tell(nc_message::kControlCode, m_line.controlCodeColumn, 1);
    }
    if (m_line.longBlockNumber.column > 0 && !m_run.longNumberTold) {
        m_run.longNumberTold = true;
        m_reporter.tell(nc_message::kBlockNumberLong, m_line.longBlockNumber.column,
                        m_line.longBlockNumber.length);
    }
}

/// From here on the program depends on what only the machine has.
void Interpretation::tellInputRead() {
    if (m_system.takeProbeRead())
        tellProbeUse(m_state, m_reporter);
    if (const int number = m_system.takeAssumedRead();
        number != 0 && m_run.assumedVariables.insert(number).second)
        m_reporter.tell(nc_message::kVariableAssumed, 1, 0, {fmt::format("#{}", number)});
    if (!m_values.takeInputRead() || !m_state.inputAssumed)
        return;
    m_state.inputAssumed = false;
    m_reporter.tell(nc_message::kInputUsed, 1, 0);
}

/// What the line orders is not known, so the axes that it names may be anywhere afterwards.
void Interpretation::skipUnreadable(std::string_view text, bool first) {
    const ReadError& error = *m_line.error;
    m_reporter.tell(*error.message, error.column, error.length, {readable(error.argument)});
    m_run.sourceBlocks += first ? 1 : 0;
    m_state.forget(axisLetters(text), Forgotten::reported);
    if (m_dialect.streamed) // grbl forgets a line that it refuses
        return;
    const ReadableWords words = readableWords(text);
    FlowRequest request;
    Execution execution = executionOf(words.block, request);
    keepModes(execution, words.codesKnown);
}

/// LinuxCNC runs what is between two "%". One alone is forgiven at the end of the file.
void Interpretation::handlePercent(std::size_t index) {
    if (m_dialect.streamed) {
        m_reporter.tell(nc_message::kPercentRefused, 1, 1);
        return;
    }
    if (!m_run.percentOpen && m_run.sourceBlocks == 0) {
        m_run.percentOpen = true;
    } else if (m_run.percentOpen) {
        m_run.percentClosed = true;
        m_finished = true;
    } else if (firstTextFrom(index + 1) == m_text.lineCount()) {
        m_reporter.tell(nc_message::kPercentUnpaired, 1, 1);
        m_run.percentClosed = true;
        m_finished = true;
    } else {
        m_run.linesSeen = firstTextFrom(index + 1) + 1;
        m_reporter.tell(nc_message::kPercentInside, 1, 1);
    }
}

/// The first line from `index` on that holds anything; the number of lines where there is none. Each of many
/// lines with a "%" asks, so that what was looked through is remembered.
std::size_t Interpretation::firstTextFrom(std::size_t index) {
    auto& [first, end] = m_blankLines;
    if (index >= first && index < end)
        return end;
    first = index;
    while (index < m_text.lineCount() &&
           m_text.line(index).find_first_not_of(" \t\v\f\x1a%") == std::string_view::npos)
        ++index;
    end = index;
    return end;
}

void Interpretation::tellAboutTheWhole(std::size_t linesRead) {
    if (m_state.compensation.on)
        m_reporter.tellInAnyCase(nc_message::kCompensationAtEnd, 1, 0);
    if (!m_run.splines.nurbs.points.empty())
        m_reporter.tellInAnyCase(nc_message::kNurbsOpen, 1, 0);
    const std::size_t rest = firstTextFrom(linesRead);
    if ((m_state.ended || m_run.percentClosed) && rest < m_text.lineCount()) {
        m_reporter.beginLine(static_cast<std::uint32_t>(rest + 1));
        m_reporter.tellInAnyCase(m_state.ended ? nc_message::kAfterEnd : nc_message::kAfterPercent, 1, 0);
    }
    if (m_program->motionCount() == 0)
        m_reporter.tellInAnyCase(nc_message::kNoMotion, 1, 0);
    else if (!m_state.ended && !m_run.percentClosed)
        m_reporter.tellInAnyCase(nc_message::kNoProgramEnd, 1, 0);
    tellNeverKnown();
    if (m_options.lint)
        tellUnseen();
}

/// What only the whole program shows: lines without a way to them, tools that are never changed to.
void Interpretation::tellUnseen() {
    for (const auto& [line, leaving] : m_run.unreachable.find(m_text, m_dialect.macros)) {
        m_reporter.beginLine(static_cast<std::uint32_t>(line + 1));
        m_reporter.tell(nc_message::kUnreachable, 1, 0, {std::to_string(leaving + 1)});
    }
    for (const auto& [tool, selected] : m_run.lint.missingTools) {
        m_reporter.beginLine(selected.line);
        m_reporter.tell(nc_message::kToolNotInTable, selected.word, {std::to_string(tool)});
    }
}

/// Axes without which a motion cut nothing were told there.
void Interpretation::tellNeverKnown() {
    const auto never = static_cast<std::uint8_t>(kAllAxes & ~(m_state.everKnown | m_state.unknownTold));
    if (never != 0 && m_program->motionCount() > 0 && !m_options.assumeStartAtZero)
        m_reporter.tellInAnyCase(nc_message::kNeverKnown, 1, 0, {namesOfAxes(never)});
}

} // namespace proveout
