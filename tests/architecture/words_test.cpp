// SPDX-License-Identifier: GPL-3.0-or-later
// The words of messages, labels and pages, read from the sources: terms of the trade and not translated
// idioms.
#include <array>
#include <cctype>
#include <cstddef>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace proveout {
namespace {

struct WordRule {
    const char* pattern; ///< ECMAScript, case-insensitive
    const char* say;     ///< what to say instead
};

/// Only phrases that are wrong in every context, because a pattern cannot check the context.
constexpr std::array kRules{
    WordRule{R"(\banew\b)", "again"},
    WordRule{R"(\bvouch)", "verified, guaranteed"},
    WordRule{R"(\bnobody\b)", "unknown"},
    WordRule{R"(\b(?:whoever|who wants)\b)", "name the actor"},
    WordRule{R"(\b(?:is|are) none\b)", "there is no …"},
    WordRule{R"(\bany more\b)", "no longer"},
    WordRule{R"((?:\b(?!there\b)\w+|[^\w\s]) is no\b(?! longer))", "is not a …"},
    WordRule{R"(\bset-up\b)", "setup"},
    WordRule{R"(\btak(?:e|en) back\b)", "undo"},
    WordRule{R"(\bfor good\b)", "always, permanently"},
    WordRule{R"(\bnot to be had\b)", "not available"},
    WordRule{R"(\bheld back\b)", "off, delayed"},
    WordRule{R"(\b(?:blocks?|motions?) that moves?\b(?! below))", "motion block"},
    WordRule{R"(\bmoving blocks?\b)", "motion block"},
    WordRule{R"(\b(?:go|goes|going) on\b)", "continue"},
    WordRule{R"(\bbehind (?:this|it|them|[GM]\d+|the (?:block|line|word|comma|tool change))\b)", "after"},
    WordRule{R"(\bstands\b(?! (?:still|upright)))", "is"},
    WordRule{R"(\blies\b(?! in memory))", "is"},
    WordRule{R"(\b(?:tells|is told|are told|told by)\b)", "reported, shown"},
    WordRule{R"(\bno order of\b)", "not supported by"},
    WordRule{R"(\bcarried out\b)", "simulated, executed"},
    WordRule{R"(\bholds next\b)", "Breakpoint: …"},
    WordRule{R"(\bcaret (?:line|position)\b)", "cursor"},
    WordRule{R"(\blargest feed\b)", "maximum feed rate"},
    WordRule{R"(\bcorner deviation\b)", "cornering tolerance"},
    WordRule{R"(\brapid X, Y\b)", "rapid traverse X/Y"},
    WordRule{R"(\bspindle[^.]*\b1/min\b)", "rpm"},
    WordRule{R"(\bplay head\b)", "current block"},
    WordRule{R"(\bthe machine's (?:zero|time)\b)", "machine zero, machine time"},
    WordRule{R"(\bmemory than there is\b)", "There is not enough memory …"},
    WordRule{R"(\bhad to stop\b)", "failed"},
    WordRule{R"(\bmay be taken\b)", "is available"},
    WordRule{R"(\bkept version\b)", "backup"},
    WordRule{R"(\bR level\b)", "R plane"},
    WordRule{R"(\breference point\b)", "reference position"},
    WordRule{R"(\bradius correction\b)", "cutter compensation"},
    WordRule{R"(\bstandard sizes\b)", "default sizes"},
    WordRule{R"(\bto the letter\b)", "exactly"},
    WordRule{R"(\bpresent (?:method|setup|parameters)\b)", "current"},
    WordRule{R"(\bplace of the (?:stock|part)\b)", "point on the stock, work offset"},
    WordRule{R"(\bmemory to go back\b)", "Rewind Memory"},
    WordRule{R"(\breturn from jump\b)", "Back to Previous Position"},
    WordRule{R"(\bmade this\b)", "Go to Cutting Block"},
    WordRule{R"(\b(?:look closer|closer look)\b)", "Magnifier, detail region"},
    WordRule{R"(\bbox of interest\b)", "detail region"},
    WordRule{R"(\bsomething wrong\b)", "a fault"},
    WordRule{R"(\bstop of the program\b)", "program stop"},
    WordRule{R"(\bthe rapid motion removes\b)", "Rapid move cuts stock …"},
    WordRule{R"(\bbegins to cut\b)", "cuts"},
    WordRule{R"(\bthe word \{\} has no number\b)", "{} word without a value."},
    WordRule{R"(\bthe block has two\b)", "Duplicate {} word."},
    WordRule{R"(\bdoes not exist on a three-axis machine\b)", "… axis ignored (three-axis machine)."},
    WordRule{R"(\bzero of the work offset\b)", "Work offset"},
    WordRule{R"(\btool selected next\b)", "Next tool"},
    WordRule{R"(\bposition in the program\b)", "Program position"},
    WordRule{R"(\bdistances of arc cent(?:re|er)s\b)", "arc distance mode"},
    WordRule{R"(\bknown to the machine only\b)", "unknown"},
};

/// The closing quote of the literal whose content begins at `begin`.
std::size_t closing(std::string_view text, std::size_t begin, char quote) {
    std::size_t at = begin;
    while (at < text.size() && text[at] != quote)
        at += text[at] == '\\' ? 2U : 1U;
    return at;
}

bool isLetterOrDigit(char character) {
    return std::isalnum(static_cast<unsigned char>(character)) != 0;
}

/// The string literals of C++, with adjacent ones joined; escape sequences stay as written.
std::vector<std::string> literalsOf(std::string_view text) {
    std::vector<std::string> literals;
    bool adjoins = false;
    std::size_t at = 0;
    while (at < text.size()) {
        const char character = text[at];
        if (text.substr(at, 2) == "//") {
            at = text.find('\n', at);
        } else if (text.substr(at, 2) == "/*") {
            const std::size_t end = text.find("*/", at + 2);
            at = end == std::string_view::npos ? end : end + 2;
        } else if (text.substr(at, 2) == "R\"") {
            const std::size_t open = text.find('(', at);
            const std::string end = ')' + std::string(text.substr(at + 2, open - at - 2)) + '"';
            const std::size_t close = text.find(end, open);
            literals.emplace_back(text.substr(open + 1, close - open - 1));
            at = close == std::string_view::npos ? close : close + end.size();
            adjoins = false;
        } else if (character == '"') {
            const std::size_t end = closing(text, at + 1, '"');
            if (!adjoins)
                literals.emplace_back();
            literals.back() += text.substr(at + 1, end - at - 1);
            at = end + 1;
            adjoins = true;
        } else if (character == '\'' && (at == 0 || !isLetterOrDigit(text[at - 1]))) { // not 1'000
            at = closing(text, at + 1, '\'') + 1;
            adjoins = false;
        } else {
            adjoins = adjoins && std::isspace(static_cast<unsigned char>(character)) != 0;
            ++at;
        }
    }
    return literals;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// The texts of a file that users read; literals only if they contain a blank, as others are keys.
std::vector<std::string> textsOf(const SourceFile& file) {
    if (file.path.ends_with(".md") && !file.in("translations")) // the glossary also lists the wrong words
        return linesOf(file.text);
    if (!file.isCpp() || !(file.in("core") || file.in("ui") || file.in("app")))
        return {};
    std::vector<std::string> texts;
    for (std::string& literal : literalsOf(file.text))
        if (literal == "1/min" || literal.find(' ') != std::string::npos)
            texts.push_back(std::move(literal));
    return texts;
}

TEST(Words, LiteralsAreReadFromCpp) {
    EXPECT_EQ(literalsOf("a(\"b \\\" c\"\n  \"d\", '\"', 1'000, R\"(e \"f)\"); // \"g\"\n/* \"h\" */ \"i\""),
              (std::vector<std::string>{"b \\\" cd", "e \"f", "i"}));
}

TEST(Words, AreThoseOfTheTrade) {
    std::vector<std::regex> patterns;
    patterns.reserve(kRules.size());
    for (const WordRule& rule : kRules)
        patterns.emplace_back(rule.pattern, std::regex::ECMAScript | std::regex::icase);
    std::size_t read = 0;
    for (const SourceFile& file : sourceTree()) {
        for (const std::string& text : textsOf(file)) {
            ++read;
            for (std::size_t rule = 0; rule < kRules.size(); ++rule) {
                std::smatch found;
                if (std::regex_search(text, found, patterns[rule]))
                    ADD_FAILURE() << file.path << ": “" << found.str() << "” in “" << text
                                  << "”; say: " << kRules[rule].say;
            }
        }
    }
    EXPECT_GT(read, 1500U) << "a rule that reads nothing would hold for ever";
}

} // namespace
} // namespace proveout
