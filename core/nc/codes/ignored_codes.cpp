// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/ignored_codes.h"

#include <algorithm>
#include <charconv>

#include "core/nc/text/characters.h"
#include "core/nc/text/messages.h"

namespace proveout {

namespace {

constexpr std::string_view kSeparators = ",; \t";

/// "16" or "M16".
std::optional<int> mCode(std::string_view word) {
    if (!word.empty() && upperCase(word.front()) == 'M')
        word.remove_prefix(1);
    int number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool whole = error == std::errc() && end == word.data() + word.size();
    return whole && number >= 0 && number <= kLargestMCode ? std::optional(number) : std::nullopt;
}

} // namespace

void IgnoredCode::add(std::uint32_t line, int atColumn, int ofLength) {
    if (count++ == 0) {
        column = atColumn;
        length = ofLength;
    }
    if (std::ranges::find(lines, line) != lines.end())
        return;
    if (lines.size() < kMostLines)
        lines.push_back(line);
    else
        moreLines = true;
}

std::string linesOf(const IgnoredCode& code) {
    std::string text;
    for (const std::uint32_t line : code.lines)
        text += (text.empty() ? "" : ", ") + std::to_string(line);
    return code.moreLines ? text + " …" : text;
}

Result<std::set<int>> parseMCodes(std::string_view text) {
    std::set<int> codes;
    for (std::size_t at = text.find_first_not_of(kSeparators); at != std::string_view::npos;
         at = text.find_first_not_of(kSeparators, at)) {
        const std::size_t end = std::min(text.find_first_of(kSeparators, at), text.size());
        const std::string_view word = text.substr(at, end - at);
        const auto number = mCode(word);
        if (!number)
            return failure(nc_message::kCodeList, {std::string(word), std::to_string(kLargestMCode)});
        codes.insert(*number);
        at = end;
    }
    return codes;
}

std::string formatMCodes(const std::set<int>& codes) {
    std::string text;
    for (const int number : codes)
        text += (text.empty() ? "" : ", ") + std::to_string(number);
    return text;
}

std::optional<int> unknownMCode(const Diagnostic& diagnostic) {
    const std::string_view id = diagnostic.id;
    const bool unknown = id == nc_message::kUnknownMCode.id || id == nc_message::kCodeForeign.id;
    if (!unknown || diagnostic.arguments.empty() || !diagnostic.arguments.front().text().starts_with('M'))
        return {};
    return mCode(diagnostic.arguments.front().text());
}

} // namespace proveout
