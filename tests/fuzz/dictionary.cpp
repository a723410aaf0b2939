// SPDX-License-Identifier: GPL-3.0-or-later
// Prints libFuzzer's dictionary of NC words: what the table of codes holds, and the keywords beside it.
#include <cstdio>
#include <string>

#include "core/nc/codes.h"

namespace {

const char* const kWords[] = {
    "\\x0a",      "\\x0d",    "%",         "/",        "(",        ")",         ";",        "(MSG,",
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
    return std::to_string(tenths / 10) + (tenths % 10 != 0 ? "." + std::to_string(tenths % 10) : "");
}

} // namespace

int main() {
    for (const char* word : kWords)
        std::printf("\"%s\"\n", word);
    for (const proveout::Dialect& dialect : proveout::dialects()) {
        for (const proveout::CodeRow* row : proveout::codesOf(dialect.id).rows())
            std::printf("\"%c%s\"\n", row->letter, numberOf(row->tenths).c_str());
    }
    for (const proveout::LetterRow& row : proveout::letters())
        std::printf("\"%c1\"\n\" %c-2.5\"\n", row.letter, row.letter);
    return 0;
}
