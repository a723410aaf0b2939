// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/text_search.h"

#include <algorithm>

namespace proveout {

namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool isLetter(char c) {
    // A byte beyond ASCII belongs to a letter of another alphabet.
    return (lower(c) >= 'a' && lower(c) <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

bool isOfNumber(char c) {
    return (c >= '0' && c <= '9') || c == '.';
}

/// Whether two adjacent bytes belong to the same word.
bool joined(char a, char b) {
    return (isLetter(a) && isLetter(b)) || (isOfNumber(a) && isOfNumber(b));
}

bool isWhole(std::string_view text, std::size_t begin, std::size_t end) {
    return (begin == 0 || !joined(text[begin - 1], text[begin])) &&
           (end == text.size() || !joined(text[end - 1], text[end]));
}

} // namespace

bool matchesAt(std::string_view text, const TextPattern& pattern, std::size_t at) {
    const std::string& wanted = pattern.bytes;
    if (wanted.empty() || at > text.size() || text.size() - at < wanted.size())
        return false;
    const auto same = [](char a, char b) { return lower(a) == lower(b); };
    return std::equal(wanted.begin(), wanted.end(), text.begin() + static_cast<std::ptrdiff_t>(at), same) &&
           (!pattern.wholeWords || isWhole(text, at, at + wanted.size()));
}

std::optional<std::size_t> findForward(std::string_view text, const TextPattern& pattern, std::size_t from,
                                       std::size_t stop) {
    stop = std::min(stop, text.size());
    const char first = pattern.bytes.empty() ? '\0' : lower(pattern.bytes.front());
    for (std::size_t at = from; at < stop; ++at) {
        if (lower(text[at]) == first && matchesAt(text, pattern, at))
            return at;
    }
    return std::nullopt;
}

std::optional<std::size_t> findBackward(std::string_view text, const TextPattern& pattern,
                                        std::size_t before) {
    for (std::size_t at = std::min(before, text.size()); at-- > 0;) {
        if (matchesAt(text, pattern, at))
            return at;
    }
    return std::nullopt;
}

} // namespace proveout
