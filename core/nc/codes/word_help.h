// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of a word of a line, for tooltips.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/nc/codes/codes.h"

namespace proveout {

struct WordHelp {
    std::size_t begin = 0; ///< of the word, as an index into the line
    std::size_t end = 0;
    std::string word;            ///< "G54.1", "X"; as written in the tables
    const char* name = nullptr;  ///< marked with PROVEOUT_TEXT; null if the dialect does not know the code
    const char* group = nullptr; ///< of codes: their modal group, marked with PROVEOUT_TEXT
    bool supported = true;
    bool parameter = false; ///< "#5", "#<depth>"
};

/// The word or the parameter at index `at` of a line; nothing in comments, between words, and in keywords.
[[nodiscard]] std::optional<WordHelp> helpAt(std::string_view line, std::size_t at, DialectId dialect);

} // namespace proveout
