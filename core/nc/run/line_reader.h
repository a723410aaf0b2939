// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "core/nc/flow/call_stack.h"
#include "core/nc/flow/control_variables.h"
#include "core/nc/program/reporter.h"
#include "core/nc/run/serial_line.h"
#include "core/nc/state/machine_state.h"
#include "core/nc/text/lexer.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// How far the main text was read, and what was found in it. A value.
struct ReadState {
    std::size_t linesRead = 0; ///< number of lines up to the last one that was reached
    std::size_t linesSeen = 0; ///< number of lines up to the last one on which any result depends
    std::size_t sourceBlocks = 0;
    double mainNumber = 0; ///< O of the main program
    bool percentOpen = false;
    bool percentClosed = false; ///< the text has ended, whatever follows
    // Reported once.
    SerialLine::Reported serial;
    bool controlCodeReported = false;
    bool longNumberReported = false;
};

/// Reads the current line of the call stack, and reports what concerns it as text: the first "%" and the
/// last, lines received over a serial line, the meaning of control codes and long lines. Keeps references to
/// its arguments.
class LineReader {
public:
    enum class Content : std::uint8_t {
        nothing,    ///< nothing to execute
        unreadable, ///< the line has an error, not yet reported
        words       ///< a statement, a block, assignments
    };

    LineReader(const NcText& text, const Dialect& dialect, ControlVariables& variables, MachineState& state,
               ReadState& read, CallStack& calls, Reporter& reporter);

    /// Moves to where the dialect's controls begin to read. Once, before the first line.
    void begin();
    Content read(Line& line);
    /// The line as it was read: characters removed by a serial line are blank.
    [[nodiscard]] std::string_view lineText() const { return m_lineText; }

    /// The first line of the main text from `index` on that is not empty; the number of lines if there is
    /// none.
    [[nodiscard]] std::size_t firstTextFrom(std::size_t index);

private:
    void skipToPercent();
    Content readText(std::size_t index, bool first, Line& line);
    bool readStreamed(std::string_view& text, bool first);
    bool beginsProgram(std::size_t index);
    void handlePercent(std::size_t index);
    void reportFirst(std::size_t index, std::string_view text);
    void reportRead(const Line& line, std::string_view text);

    const NcText& m_text; ///< the main one
    const Dialect& m_dialect;
    ControlVariables& m_variables;
    MachineState& m_state;
    ReadState& m_read;
    CallStack& m_calls;
    Reporter& m_reporter;
    SerialLine m_serial;
    std::string_view m_lineText;
    std::size_t m_loneCr; ///< line of the main text
    /// Lines that are known to be empty: from the first on, before the second.
    std::pair<std::size_t, std::size_t> m_blankLines{0, 0};
};

} // namespace proveout
