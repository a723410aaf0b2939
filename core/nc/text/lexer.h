// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/nc/text/block.h"
#include "core/nc/text/expression.h"
#include "core/nc/text/flow_word.h"
#include "core/nc/text/macro_statement.h"

namespace proveout {

/// "#…=…" of a line.
struct Assignment {
    ParameterName target;
    double value = 0;
    int column = 0;
    int length = 0;
};

/// Columns of a line, 1-based; column 0: nowhere.
struct Place {
    int column = 0;
    int length = 0;
};

/// One parsed line of an NC program. `block` is meant to be reused for the next line.
struct Line {
    Block block;
    std::vector<Assignment> assignments;     ///< take effect after the whole line was read, in this order
    std::optional<FlowWord> flow;            ///< if set, the line has nothing else, and its arguments are not
                                             ///< read
    std::optional<MacroStatement> statement; ///< if set, the words before it do not count
    bool programNumber = false;              ///< a program of custom macro B's dialect begins
    double program = 0;                      ///< its number
    std::optional<double> blockNumber;       ///< N
    bool percent = false;                    ///< a line with only "%"
    bool deleteMark = false;                 ///< begins with "/"
    int controlCodeColumn = 0;               ///< of a control code that was skipped, 0: none
    Place lateCall;                          ///< M98 or M99 of LinuxCNC with something before it
    Place longBlockNumber;                   ///< an N word that no control could store
    std::optional<ReadError> error;          ///< `block` holds the words before it
};

/// Reads a line without its line end: N word, words, comments, in any mixture of cases and blanks. Comments
/// have no effect. Parameters have the values from before the line. After an error the rest of the line is
/// not read.
void readLine(std::string_view text, const ReadContext& context, Line& line);
/// The same for the text from index `from` on, after a THEN.
void readRest(std::string_view text, std::size_t from, const ReadContext& context, Line& line);

/// The letters of the axes that a line seems to name, even if it cannot be read: the interpreter then treats
/// the positions of these axes as unknown.
[[nodiscard]] LetterSet axisLetters(std::string_view text);

} // namespace proveout
