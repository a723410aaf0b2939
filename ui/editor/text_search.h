// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace proveout {

/// The pattern of a search in an NC text. Value type.
struct TextPattern {
    std::string bytes; ///< in the encoding of the text; A to Z match regardless of case
    /// A letter at either end of the pattern must not be next to another letter, nor a digit or point next to
    /// a digit or point: "G2" is found in "G2X10" and in "N5G2", but not in "G21", "G2.1" or "G02".
    bool wholeWords = false;

    friend bool operator==(const TextPattern&, const TextPattern&) = default;
};

/// Whether the pattern matches at `at`. An empty pattern never matches.
[[nodiscard]] bool matchesAt(std::string_view text, const TextPattern& pattern, std::size_t at);

/// Start of the first match that begins in [from, stop).
[[nodiscard]] std::optional<std::size_t> findForward(std::string_view text, const TextPattern& pattern,
                                                     std::size_t from,
                                                     std::size_t stop = std::string_view::npos);

/// Start of the last match that begins before `before`.
[[nodiscard]] std::optional<std::size_t> findBackward(std::string_view text, const TextPattern& pattern,
                                                      std::size_t before);

} // namespace proveout
