// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/word_scan.h"

#include <algorithm>

#include "core/nc/text/characters.h"
#include "core/nc/text/number.h"

namespace proveout {

namespace {

std::string_view withoutBlanksAround(std::string_view text) {
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

/// The text of the comment that begins at `at`.
std::string_view textOfComment(std::string_view line, std::size_t at) {
    const std::size_t behind = behindComment(line, at);
    const bool closed = line[at] == '(' && line[behind - 1] == ')';
    return withoutBlanksAround(line.substr(at + 1, behind - at - (closed ? 2 : 1)));
}

std::size_t behindParameterName(std::string_view line, std::size_t at) {
    while (at < line.size() && (line[at] == '#' || isBlank(line[at])))
        ++at;
    if (at < line.size() && line[at] == '<')
        return std::min(line.find('>', at), line.size() - 1) + 1;
    while (at < line.size() && isDigit(line[at]))
        ++at;
    return at;
}

} // namespace

std::vector<WrittenWord> writtenWords(std::string_view line) {
    std::vector<WrittenWord> words;
    for (std::size_t at = 0; at < line.size();) {
        const char c = line[at];
        if (c == '(' || c == ';') {
            at = behindComment(line, at);
        } else if (c == '[') {
            at = behindBracket(line, at);
        } else if (c == '<') {
            at = std::min(line.find('>', at), line.size() - 1) + 1;
        } else if (c == '#') {
            at = behindParameterName(line, at);
        } else if (!isLetter(c)) {
            ++at;
        } else if (at + 1 < line.size() && isLetter(line[at + 1])) {
            while (at < line.size() && isLetter(line[at]))
                ++at;
        } else {
            const NumberRead number = readNumber(line, at + 1);
            const bool read = number.status == NumberStatus::good;
            words.push_back({upperCase(c), at, read ? number.end : at + 1,
                             read ? std::optional(number.value) : std::nullopt});
            at = words.back().end;
        }
    }
    return words;
}

std::string_view onlyComment(std::string_view line) {
    std::size_t at = skipBlanks(line, 0);
    if (at < line.size() && line[at] == '/')
        at = skipBlanks(line, at + 1);
    if (at < line.size() && upperCase(line[at]) == 'N') {
        const NumberRead number = readNumber(line, at + 1);
        if (number.status != NumberStatus::good)
            return {};
        at = skipBlanks(line, number.end);
    }
    if (at >= line.size() || (line[at] != '(' && line[at] != ';'))
        return {};
    const bool last = skipBlanks(line, behindComment(line, at)) >= line.size();
    return last ? textOfComment(line, at) : std::string_view();
}

std::string_view firstComment(std::string_view line) {
    const std::size_t at = line.find_first_of("(;");
    return at == std::string_view::npos ? std::string_view() : textOfComment(line, at);
}

} // namespace proveout
