// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/jump_target.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/nc/codes/dialects.h"
#include "core/nc/flow/flow_index.h"
#include "core/nc/flow/macro_index.h"
#include "core/nc/flow/program_files.h"
#include "core/nc/text/characters.h"
#include "core/nc/text/flow_word.h"
#include "core/nc/text/macro_statement.h"
#include "core/nc/text/number.h"
#include "core/nc/text/word_scan.h"

namespace proveout {

namespace {

constexpr double kMostNumber = 99'999'999;
constexpr int kPacked = 10'000; ///< P51002 calls program 1002 five times

bool isWithin(std::size_t at, std::size_t begin, std::size_t end) {
    return at >= begin && at < end;
}

std::optional<int> wholeOf(const WrittenWord& word) {
    const bool whole = word.value && *word.value >= 0 && *word.value <= kMostNumber &&
                       *word.value == std::round(*word.value);
    return whole ? std::optional(static_cast<int>(*word.value)) : std::nullopt;
}

/// A parameter as written in a line.
struct WrittenParameter {
    std::string name; ///< empty: its number is computed
    std::size_t begin = 0;
    std::size_t end = 0;
    bool assigned = false;
};

/// Reads the parameter whose "#" is at `at`.
WrittenParameter parameterAt(std::string_view line, std::size_t at) {
    WrittenParameter parameter{{}, at, at + 1};
    std::size_t next = skipBlanks(line, at + 1);
    if (next < line.size() && line[next] == '<') {
        const std::size_t close = line.find('>', next);
        if (close == std::string_view::npos)
            return parameter;
        parameter.end = close + 1;
        parameter.name.push_back('#');
        for (const char c : line.substr(next, parameter.end - next))
            if (!isBlank(c))
                parameter.name.push_back(lowerCase(c));
    } else {
        const std::size_t first = next;
        while (next < line.size() && isDigit(line[next]))
            ++next;
        if (next == first)
            return parameter;
        parameter.end = next;
        const std::size_t zeros = std::min(line.find_first_not_of('0', first), next - 1);
        parameter.name.push_back('#');
        parameter.name.append(line.substr(zeros, next - zeros));
    }
    next = skipBlanks(line, parameter.end);
    parameter.assigned = next < line.size() && line[next] == '=';
    return parameter;
}

/// Calls `visit` for each parameter of a line whose number or name is written, outside comments.
template<class Visit>
void eachParameter(std::string_view line, const Visit& visit) {
    for (std::size_t at = 0; at < line.size();) {
        if (line[at] == '(' || line[at] == ';') {
            at = behindComment(line, at);
            continue;
        }
        if (line[at] != '#') {
            ++at;
            continue;
        }
        const WrittenParameter parameter = parameterAt(line, at);
        if (!parameter.name.empty())
            visit(parameter);
        at = parameter.end;
    }
}

std::optional<TextPlace> assignmentIn(const NcText& text, std::size_t line, const std::string& name) {
    std::optional<TextPlace> found;
    const std::string_view content = text.line(line);
    if (content.find('#') == std::string_view::npos)
        return found;
    eachParameter(content, [&](const WrittenParameter& one) {
        if (!found && one.assigned && one.name == name)
            found = TextPlace{line, one.begin, one.end};
    });
    return found;
}

std::optional<TextPlace> findAssignment(const NcText& text, std::size_t from, const std::string& name) {
    const bool named = name.starts_with("#<");
    for (std::size_t line = from; !named && line-- > 0;)
        if (auto found = assignmentIn(text, line, name))
            return found;
    for (std::size_t line = named ? 0 : from; line < text.lineCount(); ++line)
        if (auto found = assignmentIn(text, line, name))
            return found;
    return {};
}

std::optional<JumpTarget> parameterTarget(std::string_view line, std::size_t at) {
    std::optional<JumpTarget> target;
    eachParameter(line, [&](const WrittenParameter& one) {
        if (isWithin(at, one.begin, one.end))
            target = JumpTarget{JumpKind::parameter, -1, one.name, one.begin, one.end};
    });
    return target;
}

int programNumber(const std::string& label) {
    const NumberRead number = readNumber(label, 0);
    return number.value <= kMostNumber ? static_cast<int>(number.value) : -1;
}

std::optional<JumpTarget> oWordTarget(std::string_view line, std::size_t at) {
    const auto word = hasFlowWord(line) ? readFlowWord(line) : tl::unexpected(ReadError{});
    if (!word || word->label.empty() || !isWithin(at, word->begin, word->arguments))
        return {};
    JumpTarget target{JumpKind::construct, -1, word->label, word->begin, word->arguments};
    if (word->kind == FlowKind::call || word->kind == FlowKind::sub)
        target.kind = JumpKind::sub;
    else if (word->kind == FlowKind::programNumber)
        return JumpTarget{JumpKind::program, programNumber(word->label), {}, target.begin, target.end};
    return target;
}

/// The word that calls or jumps, and what it may lead to.
struct CallCode {
    char letter;
    int number;
    JumpKind kind;
};

constexpr CallCode kMacroCalls[] = {{'M', 98, JumpKind::program},
                                    {'G', 65, JumpKind::program},
                                    {'G', 66, JumpKind::program},
                                    {'M', 97, JumpKind::block},
                                    {'M', 99, JumpKind::callerBlock}};
constexpr CallCode kRs274Calls[] = {{'M', 98, JumpKind::program}};

/// The name between < and > after a code that calls.
std::optional<JumpTarget> namedProgram(std::string_view line, const WrittenWord& code) {
    const std::size_t open = skipBlanks(line, code.end);
    if (open >= line.size() || line[open] != '<' || line.find('>', open) == std::string_view::npos)
        return {};
    const std::size_t close = line.find('>', open);
    return JumpTarget{JumpKind::program, -1, std::string(line.substr(open + 1, close - open - 1)), open,
                      close + 1};
}

/// The target of the call in a line, with the code that calls; nothing if there is none, or a computed one.
std::optional<std::pair<JumpTarget, WrittenWord>> callOf(std::string_view line, DialectId dialectId) {
    const MacroLanguage language = dialect(dialectId).macros;
    if (language == MacroLanguage::none)
        return {};
    const bool macroB = language == MacroLanguage::macroB;
    const std::vector<WrittenWord> words = writtenWords(line);
    const auto wordOf = [&](char letter) { return std::ranges::find(words, letter, &WrittenWord::letter); };
    for (const WrittenWord& code : words) {
        const auto isIt = [&](const CallCode& row) {
            return row.letter == code.letter && code.value == static_cast<double>(row.number);
        };
        const auto rows = macroB ? std::span<const CallCode>(kMacroCalls) : std::span(kRs274Calls);
        const auto row = std::ranges::find_if(rows, isIt);
        if (row == rows.end())
            continue;
        if (macroB && row->kind == JumpKind::program)
            if (auto named = namedProgram(line, code))
                return std::pair(*named, code);
        const auto p = wordOf('P');
        auto number = p == words.end() ? std::nullopt : wholeOf(*p);
        if (!number)
            return {};
        if (macroB && code.letter == 'M' && row->kind == JumpKind::program && wordOf('L') == words.end() &&
            *number >= kPacked)
            *number %= kPacked;
        return std::pair(JumpTarget{row->kind, *number, {}, p->begin, p->end}, code);
    }
    return {};
}

/// The GOTO of a line with the number of its block.
std::optional<JumpTarget> gotoOf(std::string_view line) {
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] == '(' || line[at] == ';') {
            at = behindComment(line, at) - 1;
            continue;
        }
        std::size_t behind = at;
        if (upperCase(line[at]) != 'G' || !readKeyword(line, behind, "GOTO"))
            continue;
        const NumberRead number = readNumber(line, behind);
        if (number.status != NumberStatus::good || number.value < 0 || number.value > kMostNumber)
            return {};
        return JumpTarget{JumpKind::block, static_cast<int>(number.value), {}, at, number.end};
    }
    return {};
}

/// Whether a keyword of a loop is at an index.
bool isLoopWord(std::string_view line, std::size_t at) {
    if (at >= line.size() || !isLetter(line[at]))
        return false;
    while (at > 0 && isLetter(line[at - 1]))
        --at;
    const auto begins = [&](std::string_view word) {
        std::size_t behind = at;
        return readKeyword(line, behind, word);
    };
    return begins("DO") || begins("END") || begins("WHILE");
}

std::optional<JumpTarget> macroTarget(std::string_view line, std::size_t at) {
    if (auto jump = gotoOf(line); jump && isWithin(at, jump->begin, jump->end))
        return jump;
    if (isLoopWord(line, at))
        return JumpTarget{JumpKind::construct, -1, {}, at, at + 1};
    return {};
}

bool isInComment(std::string_view line, std::size_t at) {
    for (std::size_t next = 0; next < line.size() && next <= at;) {
        const bool comment = line[next] == '(' || line[next] == ';';
        const std::size_t end = comment ? behindComment(line, next) : next + 1;
        if (comment && at < end)
            return true;
        next = end;
    }
    return false;
}

/// The word of a letter in a line, or all of the line but the blanks around it.
TextPlace placeOfLetter(const NcText& text, std::size_t line, char letter) {
    const std::string_view content = text.line(line);
    const std::vector<WrittenWord> words = writtenWords(content);
    if (const auto word = std::ranges::find(words, letter, &WrittenWord::letter); word != words.end())
        return {line, word->begin, word->end};
    std::size_t end = content.size();
    while (end > 0 && isBlank(content[end - 1]))
        --end;
    return {line, std::min(skipBlanks(content, 0), end), end};
}

/// The O-word of a line with its keyword.
std::optional<TextPlace> placeOfOWord(const NcText& text, std::size_t line) {
    if (line == FlowLine::kNone)
        return {};
    const auto word = readFlowWord(text.line(line));
    return word ? std::optional(TextPlace{line, word->begin, word->arguments}) : std::nullopt;
}

std::optional<TextPlace> findInOWords(const NcText& text, std::size_t from, const JumpTarget& target) {
    const FlowIndex index(text);
    if (target.kind == JumpKind::sub)
        return placeOfOWord(text, index.sub(target.name));
    if (target.kind == JumpKind::program)
        return placeOfOWord(text, index.program(std::to_string(target.number)));
    const FlowLine* row = target.kind == JumpKind::construct ? index.at(from) : nullptr;
    if (row == nullptr)
        return {};
    return placeOfOWord(text, row->begin != from && row->begin != FlowLine::kNone ? row->begin : row->end);
}

std::optional<TextPlace> findInMacros(const NcText& text, std::size_t from, const JumpTarget& target) {
    const MacroIndex index(text);
    const auto placed = [&](std::size_t line, char letter) {
        return line == MacroIndex::kNone ? std::nullopt : std::optional(placeOfLetter(text, line, letter));
    };
    switch (target.kind) {
    case JumpKind::block:
        return placed(index.block(target.number, from), 'N');
    case JumpKind::callerBlock: {
        // Which program called is only known in the first one, which nothing calls.
        const MacroIndex::Range& first = index.programOf(0);
        const bool inFirst = from < first.end;
        return placed(index.block(target.number, inFirst ? from : first.first), 'N');
    }
    case JumpKind::program: {
        const MacroIndex::Range* program =
            target.name.empty() ? index.program(target.number) : index.program(target.name);
        return program == nullptr ? std::nullopt : placed(program->first, 'O');
    }
    case JumpKind::construct:
        return placed(index.partner(from), '\0');
    case JumpKind::sub:
    case JumpKind::parameter:
        break;
    }
    return {};
}

} // namespace

std::optional<JumpTarget> jumpTargetAt(std::string_view line, std::size_t at, DialectId dialectId) {
    if (at >= line.size() || isInComment(line, at))
        return {};
    if (auto parameter = parameterTarget(line, at))
        return parameter;
    if (const auto call = callOf(line, dialectId)) {
        const auto& [target, code] = *call;
        if (isWithin(at, target.begin, target.end) || isWithin(at, code.begin, code.end))
            return target;
    }
    switch (dialect(dialectId).macros) {
    case MacroLanguage::oWords:
    case MacroLanguage::labels:
        return oWordTarget(line, at);
    case MacroLanguage::macroB:
        return macroTarget(line, at);
    case MacroLanguage::none:
        break;
    }
    return {};
}

std::optional<JumpTarget> blockJumpOf(std::string_view line, DialectId dialectId) {
    if (dialect(dialectId).macros != MacroLanguage::macroB)
        return {};
    if (auto jump = gotoOf(line))
        return jump;
    if (line.find_first_of("Mm") == std::string_view::npos || line.find('9') == std::string_view::npos)
        return {};
    const auto call = callOf(line, dialectId);
    return call && call->first.kind != JumpKind::program ? std::optional(call->first) : std::nullopt;
}

std::optional<TextPlace> findTarget(const NcText& text, std::size_t from, const JumpTarget& target,
                                    DialectId dialectId) {
    if (target.kind == JumpKind::parameter)
        return findAssignment(text, from, target.name);
    return dialect(dialectId).macros == MacroLanguage::macroB ? findInMacros(text, from, target)
                                                              : findInOWords(text, from, target);
}

std::vector<std::string> filesOf(const JumpTarget& target, DialectId dialectId) {
    const MacroLanguage language = dialect(dialectId).macros;
    if (target.kind == JumpKind::program && language == MacroLanguage::macroB)
        return macroFileNames(target.number, target.name);
    if (target.kind != JumpKind::sub || language != MacroLanguage::oWords)
        return {};
    std::string name = subFileName(target.name);
    return name.empty() ? std::vector<std::string>() : std::vector{std::move(name)};
}

} // namespace proveout
