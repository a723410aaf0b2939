// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a line as they are written, for listings and jumps in an editor: nothing is evaluated.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace proveout {

struct WrittenWord {
    char letter = 0;             ///< upper case
    std::size_t begin = 0;       ///< as indices into the line
    std::size_t end = 0;         ///< of a computed number: after the letter
    std::optional<double> value; ///< nothing: the number is computed, or missing
};

/// The words of a line in order. Comments, expressions, names between < and >, parameters and keywords of
/// several letters are skipped.
[[nodiscard]] std::vector<WrittenWord> writtenWords(std::string_view line);

/// The text of a line that is only a comment, after "/" and a block number, without blanks around it; empty
/// if the line has anything else.
[[nodiscard]] std::string_view onlyComment(std::string_view line);

/// The text of the first comment of a line, without blanks around it; empty if there is none.
[[nodiscard]] std::string_view firstComment(std::string_view line);

} // namespace proveout
