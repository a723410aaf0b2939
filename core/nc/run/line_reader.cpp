// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/line_reader.h"
#include "core/nc/motions/known_axes.h"

#include <algorithm>
#include <string>

#include "core/nc/text/characters.h"
#include "core/nc/text/messages.h"

namespace proveout {

LineReader::LineReader(const NcText& text, const Dialect& dialect, ControlVariables& variables,
                       MachineState& state, ReadState& read, CallStack& calls, Reporter& reporter)
    : m_text(text), m_dialect(dialect), m_variables(variables), m_state(state), m_read(read), m_calls(calls),
      m_reporter(reporter), m_serial(dialect.longestLine), m_loneCr(text.firstLoneCr()) {}

void LineReader::begin() {
    if (m_dialect.macros == MacroLanguage::macroB)
        skipToPercent();
}

/// Controls of custom macro B's dialect search for the first "%" and read from there.
void LineReader::skipToPercent() {
    constexpr std::size_t kFarthest = 1000; ///< lines of a heading
    const std::size_t most = std::min(m_text.lineCount(), kFarthest);
    m_read.linesSeen = kFarthest;
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
            m_reporter.report(nc_message::kTextBeforePercent, 1, 0);
            m_calls.jump(line);
        }
        m_read.linesSeen = line + 1;
        return;
    }
}

LineReader::Content LineReader::read(Line& line) {
    const std::size_t index = m_calls.at();
    const bool first = m_calls.inMainText() && index >= m_read.linesRead;
    const Content content = readText(index, first, line);
    if (content != Content::nothing)
        m_read.sourceBlocks += first ? 1 : 0;
    return content;
}

LineReader::Content LineReader::readText(std::size_t index, bool first, Line& line) {
    std::string_view text = m_calls.currentText();
    if (first)
        reportFirst(index, text);
    if (m_dialect.streamed && !readStreamed(text, first))
        return Content::nothing;
    m_lineText = text;
    readLine(text, m_variables.context(), line);
    if (line.deleteMark && m_variables.context().blockDelete)
        return Content::nothing;
    m_variables.reportReads();
    if (first)
        reportRead(line, text);
    if (line.error)
        return Content::unreadable;
    if (line.percent) {
        if (m_calls.inMainText())
            handlePercent(index);
        else if (m_dialect.macros == MacroLanguage::macroB && index > 0)
            m_calls.endText();
        return Content::nothing;
    }
    if (line.programNumber && !beginsProgram(index))
        return Content::nothing;
    if (line.programNumber && m_calls.inMainProgram())
        m_state.programNumber = m_read.mainNumber = line.program;
    const bool words = line.flow || line.statement || !line.block.empty() || !line.assignments.empty();
    return words ? Content::words : Content::nothing;
}

/// Reports about a line of the main text when it is first reached.
void LineReader::reportFirst(std::size_t index, std::string_view text) {
    m_read.linesRead = index + 1;
    if (index == 0 && m_text.hadByteOrderMark())
        m_reporter.report(nc_message::kByteOrderMark, 1, 0);
    if (index == m_loneCr)
        m_reporter.report(nc_message::kLoneCr, static_cast<int>(text.size() + 1), 1);
}

/// The same once its words are known.
void LineReader::reportRead(const Line& line, std::string_view text) {
    const std::size_t longest = m_dialect.streamed ? 0 : m_dialect.longestLine;
    if (longest > 0 && text.size() > longest)
        m_reporter.report(nc_message::kLineLong, static_cast<int>(longest + 1), 1,
                          {std::to_string(text.size())});
    if (line.controlCodeColumn > 0 && !m_read.controlCodeReported) {
        m_read.controlCodeReported = true;
        m_reporter.report(nc_message::kControlCode, line.controlCodeColumn, 1);
    }
    if (line.longBlockNumber.column > 0 && !m_read.longNumberReported) {
        m_read.longNumberReported = true;
        m_reporter.report(nc_message::kBlockNumberLong, line.longBlockNumber.column,
                          line.longBlockNumber.length);
    }
}

/// Reduces `text` to what the control on a serial line reads as a block; false if it reads none.
bool LineReader::readStreamed(std::string_view& text, bool first) {
    const bool block = m_serial.read(text, m_read.serial, m_reporter, m_state);
    if (!block) {
        forgetAxes(m_state, axisLetters(text));
        m_read.sourceBlocks += first ? 1 : 0;
    }
    text = m_serial.text();
    return block;
}

/// Whether an O-word begins the program that is running; any other one ends it.
bool LineReader::beginsProgram(std::size_t index) {
    const bool begins = m_calls.inMainProgram() ? m_read.sourceBlocks == 0 : index == m_calls.level().entry;
    if (!begins)
        m_calls.endText();
    return begins;
}

/// LinuxCNC runs what is between two "%". A single one is accepted at the end of the file.
void LineReader::handlePercent(std::size_t index) {
    if (m_dialect.streamed) {
        m_reporter.report(nc_message::kPercentRefused, 1, 1);
        return;
    }
    if (!m_read.percentOpen && m_read.sourceBlocks == 0) {
        m_read.percentOpen = true;
    } else if (m_read.percentOpen) {
        m_read.percentClosed = true;
    } else if (firstTextFrom(index + 1) == m_text.lineCount()) {
        m_reporter.report(nc_message::kPercentUnpaired, 1, 1);
        m_read.percentClosed = true;
    } else {
        m_read.linesSeen = firstTextFrom(index + 1) + 1;
        m_reporter.report(nc_message::kPercentInside, 1, 1);
    }
}

/// Called for each of many lines with a "%", so the searched range is remembered.
std::size_t LineReader::firstTextFrom(std::size_t index) {
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

} // namespace proveout
