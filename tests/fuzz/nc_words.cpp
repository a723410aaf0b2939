// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/nc_words.h"

#include "core/nc/codes/codes.h"
#include "core/nc/codes/dialects.h"

namespace proveout::test {

namespace {

const char* const kWords[] = {
    "\n",         "\r",       "%",         "/",        "(",        ")",         ";",        "(MSG,",
    "#",          "#1=",      "#<a>",      "#<_b>=",   "#5220",    "#5161",     "#5400",    "#5061",
    "[",          "]",        "**",        "MOD",      "AND",      "OR",        "XOR",      "EQ",
    "NE",         "GT",       "GE",        "LT",       "LE",       "ABS[",      "ACOS[",    "ASIN[",
    "ATAN[",      "]/[",      "COS[",      "EXP[",     "FIX[",     "FUP[",      "LN[",      "ROUND[",
    "SIN[",       "SQRT[",    "TAN[",      "EXISTS[#", "o100 ",    "o<s> ",     "sub",      "endsub",
    "call",       "return",   "if [",      "elseif [", "else",     "endif",     "do",       "while [",
    "endwhile",   "repeat [", "endrepeat", "break",    "continue", "#<_x>",     "#<_line>", "#<_value>",
    "#<_metric>", "GOTO",     "THEN",      "WHILE",    "DO1",      "END1",      "#0",       "N1",
    "0",          "1",        "-1",        "0.5",      "1e9",      "999999999", "0.000001",
};

std::string numberOf(int tenths) {
    std::string number = std::to_string(tenths / 10);
    if (tenths % 10 != 0)
        number.append(1, '.').append(std::to_string(tenths % 10));
    return number;
}

} // namespace

std::vector<std::string> ncWords() {
    std::vector<std::string> words(std::begin(kWords), std::end(kWords));
    for (const Dialect& dialect : dialects()) {
        for (const CodeRow* row : codesOf(dialect.id).rows())
            words.push_back(row->letter + numberOf(row->tenths));
    }
    for (const LetterRow& row : letters()) {
        words.push_back(std::string{row.letter, '1'});
        words.push_back(std::string{' ', row.letter} + "-2.5");
    }
    return words;
}

} // namespace proveout::test
