// SPDX-License-Identifier: GPL-3.0-or-later
// The characters of NC lines.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace proveout {

[[nodiscard]] constexpr bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

[[nodiscard]] constexpr bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

[[nodiscard]] constexpr char upperCase(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

[[nodiscard]] constexpr bool isCapital(char c) {
    return c >= 'A' && c <= 'Z';
}

[[nodiscard]] constexpr bool isLetter(char c) {
    return isCapital(upperCase(c));
}

[[nodiscard]] constexpr char lowerCase(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The first index from `at` on that is not a blank; the size of the line if there is none.
[[nodiscard]] constexpr std::size_t skipBlanks(std::string_view line, std::size_t at) {
    while (at < line.size() && isBlank(line[at]))
        ++at;
    return at;
}

/// The index after the comment that begins at `at`; the end of the line if it is not closed.
[[nodiscard]] constexpr std::size_t behindComment(std::string_view line, std::size_t at) {
    return line[at] == ';' ? line.size() : std::min(line.find(')', at), line.size() - 1) + 1;
}

/// The index after the bracket that closes the one at `at`; the end of the line if there is none.
[[nodiscard]] constexpr std::size_t behindBracket(std::string_view line, std::size_t at) {
    int open = 0;
    for (; at < line.size(); ++at) {
        open += line[at] == '[' ? 1 : line[at] == ']' ? -1 : 0;
        if (open == 0)
            return at + 1;
    }
    return line.size();
}

} // namespace proveout
