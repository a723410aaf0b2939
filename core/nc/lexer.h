// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/nc/block.h"
#include "core/nc/messages.h"

namespace proveout {

/// Why a line could not be read: the first thing in it that is no word.
struct ReadError {
    const Message* message = nullptr;
    int column = 0;
    int length = 0;
    std::string_view argument; ///< a part of the line
};

/// Columns of a line, 1-based; column 0: nowhere.
struct Place {
    int column = 0;
    int length = 0;
};

/// One line of an NC program, taken apart. `block` is meant to be used again for the next line.
struct Line {
    Block block;
    bool percent = false;           ///< a line with nothing but "%"
    bool deleteMark = false;        ///< begins with "/"
    int controlCodeColumn = 0;      ///< of a control code that was skipped, 0: none
    Place longBlockNumber;          ///< an N word that no control could hold
    std::optional<ReadError> error; ///< `block` holds the words before it
};

/// Reads a line without its line end: N word, words, comments, in any mixture of cases and blanks. Comments
/// order nothing. After an error the rest of the line is not read.
void readLine(std::string_view text, Line& line);

/// The letters of the axes that a line seems to name, also where it cannot be read: for the interpreter,
/// which then no longer knows where these axes stand.
[[nodiscard]] LetterSet axisLetters(std::string_view text);

} // namespace proveout
