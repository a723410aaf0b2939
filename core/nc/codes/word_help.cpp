// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/word_help.h"

#include <algorithm>
#include <fmt/format.h>

#include "core/base/text.h"
#include "core/nc/codes/dialects.h"
#include "core/nc/codes/modal_groups.h"
#include "core/nc/text/characters.h"
#include "core/nc/text/number.h"

namespace proveout {

namespace {

std::size_t behindLetters(std::string_view line, std::size_t at) {
    while (at < line.size() && isLetter(line[at]))
        ++at;
    return at;
}

/// The end of a parameter: "#5", "##5", "#<name>"; one with a computed number ends after its "#".
std::size_t behindParameter(std::string_view line, std::size_t at) {
    if (at + 1 < line.size() && line[at + 1] == '<')
        return std::min(line.find('>', at), line.size() - 1) + 1;
    std::size_t end = line.find_first_not_of('#', at);
    while (end < line.size() && isDigit(line[end]))
        ++end;
    return std::min(end, line.size());
}

WordHelp helpForParameter(std::string_view line, std::size_t begin, std::size_t end) {
    WordHelp help;
    help.begin = begin;
    help.end = end;
    help.word = line.substr(begin, end - begin);
    help.name = PROVEOUT_TEXT("Core", "parameter");
    help.parameter = true;
    return help;
}

WordHelp helpFor(char letter, const NumberRead& number, DialectId dialect) {
    WordHelp help;
    if (letter != 'G' && letter != 'M') {
        help.word = std::string(1, letter);
        const auto row = std::ranges::find(letters(), letter, &LetterRow::letter);
        if (row != letters().end())
            help.name = row->name;
        return help;
    }
    help.word = fmt::format("{}{:g}", letter, number.value);
    const CodeRow* row = codesOf(dialect).find(Word{letter, number.value, 0, 0});
    help.supported = row != nullptr && row->supported();
    if (row != nullptr) {
        help.name = row->name;
        help.group = nameOf(row->group);
    }
    return help;
}

} // namespace

std::optional<WordHelp> helpAt(std::string_view line, std::size_t at, DialectId dialect) {
    for (std::size_t i = 0; i < line.size() && i <= at;) {
        if (line[i] == '(' || line[i] == ';') {
            i = behindComment(line, i);
        } else if (line[i] == '#') {
            const std::size_t end = behindParameter(line, i);
            if (at < end)
                return helpForParameter(line, i, end);
            i = end;
        } else if (!isLetter(line[i])) {
            ++i;
        } else if (const std::size_t behind = behindLetters(line, i); behind > i + 1) {
            i = behind;
        } else {
            const NumberRead number = readNumber(line, i + 1);
            const bool read = number.status == NumberStatus::good;
            const std::size_t end = read ? number.end : i + 1;
            if (at < end && (read || (upperCase(line[i]) != 'G' && upperCase(line[i]) != 'M'))) {
                WordHelp help = helpFor(upperCase(line[i]), number, dialect);
                help.begin = i;
                help.end = end;
                return help;
            }
            i = end;
        }
    }
    return {};
}

std::vector<HelpSentence> helpSentences(const WordHelp& help, DialectId dialectId) {
    const char* control = dialect(dialectId).name;
    if (help.name == nullptr)
        return {{PROVEOUT_TEXT("Core", "{}: unknown ({})"), {help.word, control}}};
    std::vector<HelpSentence> sentences{
        {PROVEOUT_TEXT("Core", "{}: {} ({})"), {help.word, help.name, control}}};
    if (help.group != nullptr)
        sentences.push_back({PROVEOUT_TEXT("Core", "Modal group: {}"), {help.group}});
    if (!help.supported)
        sentences.push_back(
            {PROVEOUT_TEXT("Core", "Not supported: results after this block are unverified"), {}});
    return sentences;
}

} // namespace proveout
