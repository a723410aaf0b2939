// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of a word of a line, for tooltips.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/argument.h"
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

/// One line of a tooltip: each `{}` of the text, which is marked with PROVEOUT_TEXT, is replaced by the next
/// argument.
struct HelpSentence {
    const char* text = "";
    std::vector<Argument> arguments; ///< of the first sentence the first one is the word
};

/// The meaning of a word in a dialect, in one to three lines.
[[nodiscard]] std::vector<HelpSentence> helpSentences(const WordHelp& help, DialectId dialect);

} // namespace proveout
