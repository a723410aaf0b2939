// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/flow_word.h"

#include <algorithm>

#include "core/nc/text/characters.h"
#include "core/nc/text/number.h"

namespace proveout {

namespace {

struct Keyword {
    std::string_view word;
    FlowKind kind;
};

// A word that is the beginning of another one comes after it.
constexpr Keyword kKeywords[] = {
    {"sub", FlowKind::sub},
    {"endsub", FlowKind::endSub},
    {"call", FlowKind::call},
    {"return", FlowKind::returns},
    {"if", FlowKind::ifs},
    {"elseif", FlowKind::elseIf},
    {"else", FlowKind::elses},
    {"endif", FlowKind::endIf},
    {"do", FlowKind::doLoop},
    {"while", FlowKind::whileLoop},
    {"endwhile", FlowKind::endWhile},
    {"repeat", FlowKind::repeat},
    {"endrepeat", FlowKind::endRepeat},
    {"break", FlowKind::breaks},
    {"continue", FlowKind::continues},
};

/// The position of the O of a line, or the end of the line.
std::size_t placeOfO(std::string_view line) {
    std::size_t at = skipBlanks(line, 0);
    if (at < line.size() && line[at] == '/')
        at = skipBlanks(line, at + 1);
    if (at < line.size() && lowerCase(line[at]) == 'n') {
        const NumberRead number = readNumber(line, at + 1);
        at = skipBlanks(line, number.status == NumberStatus::good ? number.end : line.size());
    }
    return at < line.size() && lowerCase(line[at]) == 'o' ? at : line.size();
}

tl::unexpected<ReadError> fail(const FindingRow& message, std::size_t begin, std::size_t end,
                               std::string_view argument = {}) {
    return tl::unexpected(readError(message, begin, end, argument));
}

/// Reads the label after the O; returns the index after it.
tl::expected<std::size_t, ReadError> readLabel(std::string_view line, FlowWord& word) {
    const std::size_t at = word.labelAt;
    const char first = at < line.size() ? line[at] : '\0';
    if (first == '<') {
        const std::size_t end = line.find('>', at);
        if (end == std::string_view::npos)
            return fail(nc_message::kNameUnclosed, at, line.size());
        for (const char c : line.substr(at + 1, end - at - 1)) {
            if (!isBlank(c))
                word.label.push_back(lowerCase(c));
        }
        if (word.label.empty())
            return fail(nc_message::kNameEmpty, at, end + 1);
        return end + 1;
    }
    if (first == '[')
        return behindBracket(line, at);
    if (first == '#') {
        std::size_t end = skipBlanks(line, at + 1);
        if (end < line.size() && line[end] == '<')
            end = std::min(line.find('>', end), line.size() - 1) + 1;
        else
            end = readNumber(line, end).end;
        return end;
    }
    const NumberRead number = readNumber(line, at);
    if (number.status != NumberStatus::good)
        return fail(nc_message::kNumberMissing, word.begin, word.begin + 1, line.substr(word.begin, 1));
    if (number.value < 0 || number.value != static_cast<double>(static_cast<long long>(number.value)))
        return fail(nc_message::kLabelNotWhole, word.begin, number.end);
    word.label = std::to_string(static_cast<long long>(number.value));
    return number.end;
}

} // namespace

bool hasFlowWord(std::string_view line) {
    return placeOfO(line) < line.size();
}

tl::expected<FlowWord, ReadError> readFlowWord(std::string_view line) {
    FlowWord word;
    word.begin = placeOfO(line);
    word.labelAt = skipBlanks(line, word.begin + 1);
    const auto behindLabel = readLabel(line, word);
    if (!behindLabel)
        return tl::unexpected(behindLabel.error());
    const std::size_t at = skipBlanks(line, *behindLabel);
    std::string letters;
    std::size_t end = at;
    for (std::size_t i = at; i < line.size() && (isLetter(line[i]) || isBlank(line[i])); ++i) {
        if (!isLetter(line[i]))
            continue;
        letters.push_back(lowerCase(line[i]));
        end = i + 1;
    }
    if (letters.empty()) {
        word.arguments = at;
        return word;
    }
    const auto* row = std::ranges::find(kKeywords, std::string_view(letters), &Keyword::word);
    if (row == std::end(kKeywords))
        return fail(nc_message::kFlowKeyword, at, end, line.substr(at, end - at));
    word.kind = row->kind;
    word.arguments = end;
    return word;
}

std::string_view keyword(FlowKind kind) {
    const auto* row = std::ranges::find(kKeywords, kind, &Keyword::kind);
    return row == std::end(kKeywords) ? std::string_view("O") : row->word;
}

} // namespace proveout
