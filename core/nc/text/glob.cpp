// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/glob.h"

#include "core/nc/text/characters.h"

#include <cstddef>

namespace proveout {

namespace {

bool isOfName(char c) {
    return isDigit(c) || (c >= 'A' && c <= 'Z') || c == '_';
}

} // namespace

bool matchesGlob(std::string_view pattern, std::string_view text) {
    // Only the last "~" is ever retried: whatever matched before it matches regardless of where that begins.
    constexpr std::size_t kNone = std::string_view::npos;
    std::size_t p = 0;
    std::size_t t = 0;
    std::size_t star = kNone;
    std::size_t from = 0;
    const auto run = [&](bool (*is)(char)) {
        const std::size_t begin = t;
        while (t < text.size() && is(text[t]))
            ++t;
        return t > begin;
    };
    const auto step = [&] {
        const char c = pattern[p];
        if (c == '#' || c == '@')
            return run(c == '#' ? isDigit : isOfName);
        if (t >= text.size())
            return false;
        if (c == '?')
            return isDigit(text[t++]);
        if (c == '\\' && p + 1 < pattern.size())
            return pattern[++p] == text[t++];
        return c == text[t++];
    };
    while (true) {
        if (p < pattern.size() && pattern[p] == '~') {
            star = ++p;
            from = t;
            if (p == pattern.size())
                return true;
            continue;
        }
        if (p == pattern.size() && t == text.size())
            return true;
        if (p < pattern.size() && step()) {
            ++p;
            continue;
        }
        if (star == kNone || from >= text.size())
            return false;
        p = star;
        t = ++from;
    }
}

} // namespace proveout
