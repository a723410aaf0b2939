// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace proveout {

/// What is looked for in an NC text. Value type.
struct TextPattern {
    std::string bytes; ///< in the encoding of the text; the letters A to Z match in either case
    /// A letter at an end of the pattern has no letter beside it, a digit or point no digit or point: "G2" is
    /// found in "G2X10" and in "N5G2", not in "G21", "G2.1" or "G02".
    bool wholeWords = false;

    friend bool operator==(const TextPattern&, const TextPattern&) = default;
};

/// Whether the pattern stands at `at`. Nothing is found of an empty one.
[[nodiscard]] bool matchesAt(std::string_view text, const TextPattern& pattern, std::size_t at);

/// Where the first match begins of those that begin in [from, stop).
[[nodiscard]] std::optional<std::size_t> findForward(std::string_view text, const TextPattern& pattern,
                                                     std::size_t from,
                                                     std::size_t stop = std::string_view::npos);

/// Where the last match begins of those that begin before `before`.
[[nodiscard]] std::optional<std::size_t> findBackward(std::string_view text, const TextPattern& pattern,
                                                      std::size_t before);

} // namespace proveout
