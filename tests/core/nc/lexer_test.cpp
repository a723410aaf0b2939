// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/dialects.h"
#include "core/nc/text/lexer.h"

#include <gtest/gtest.h>
#include <string>

namespace proveout {

namespace {

struct NoValues : SystemValues {
    [[nodiscard]] std::optional<double> numbered(int /*number*/) const override { return {}; }
    [[nodiscard]] const FindingRow* refusal(int /*number*/) const override { return nullptr; }
    [[nodiscard]] std::optional<double> named(std::string_view /*name*/) const override { return {}; }
};

Line lineOf(std::string_view text) {
    Line line;
    readLine(text, {Parameters(), NoValues(), dialect(DialectId::linuxcnc)}, line);
    return line;
}

/// "X4" at column 1 with length 2 as "X4@1+2".
std::string shown(const Word& word) {
    std::string value = std::to_string(word.value);
    value.erase(value.find_last_not_of('0') + 1);
    if (value.ends_with('.'))
        value.pop_back();
    return word.letter + value + "@" + std::to_string(word.column) + "+" + std::to_string(word.length);
}

} // namespace

TEST(Lexer, ReadsWordsWithTheirPlaces) {
    const Line line = lineOf("N10 G1 x1.5(a)Y -2 ;rest X9");
    ASSERT_FALSE(line.error);
    ASSERT_EQ(line.block.codes().size(), 1U);
    EXPECT_EQ(shown(line.block.codes()[0]), "G1@5+2");
    EXPECT_EQ(shown(line.block.word('X')), "X1.5@8+4");
    EXPECT_EQ(shown(line.block.word('Y')), "Y-2@15+4");
    EXPECT_FALSE(line.block.has('N')) << "block numbers are labels";
}

TEST(Lexer, KeepsCodesInTheOrderOfTheText) {
    const Line line = lineOf("M3G90.1 g 2 M8");
    ASSERT_EQ(line.block.codes().size(), 4U);
    EXPECT_EQ(shown(line.block.codes()[0]), "M3@1+2");
    EXPECT_EQ(shown(line.block.codes()[1]), "G90.1@3+5");
    EXPECT_EQ(shown(line.block.codes()[2]), "G2@9+3");
    EXPECT_EQ(shown(line.block.codes()[3]), "M8@13+2");
}

TEST(Lexer, KnowsLinesThatOrderNothing) {
    for (const char* text : {"", "   \t", "(only this)", "; only this", "N10", "/", "N1 (a) ; b"}) {
        const Line line = lineOf(text);
        EXPECT_FALSE(line.error) << text;
        EXPECT_TRUE(line.block.empty()) << text;
    }
    EXPECT_TRUE(lineOf("/ G0").deleteMark);
    EXPECT_TRUE(lineOf(" % ").percent);
    EXPECT_TRUE(lineOf("%(tape)").percent);
    EXPECT_EQ(lineOf("O1234 (part)").flow->kind, FlowKind::programNumber);
    EXPECT_EQ(lineOf("O1234 (part)").flow->label, "1234");
}

TEST(Lexer, SkipsControlCodesOfSerialLines) {
    const Line line = lineOf("\x11G0\x13 X1\x1a");
    EXPECT_FALSE(line.error);
    EXPECT_EQ(line.block.value('X'), 1);
    EXPECT_GT(line.controlCodeColumn, 0);
}

TEST(Lexer, PointsAtWhatItCannotRead) {
    struct Case {
        const char* text;
        const char* id;
        int column;
        int length;
    };
    for (const Case& c : {Case{"G0 X--1", "number-double-sign", 5, 2},
                          Case{"G0 X1.2.3", "number-two-points", 8, 1},
                          Case{"G0 Xnan", "number-missing", 5, 1},
                          Case{"G0 X", "number-missing", 4, 1},
                          Case{"G0 X-", "number-missing", 4, 2},
                          Case{"G0 X Y1", "number-missing", 6, 1},
                          Case{"G0 X\xe2\x88\x92"
                               "10",
                               "bad-character", 5, 3},
                          Case{"G0 \xff X1", "bad-character", 4, 1},
                          Case{"G0 X1 )", "bad-character", 7, 1},
                          Case{"5 G0", "bad-character", 1, 1},
                          Case{"G0 X1 /G0", "bad-character", 7, 1},
                          Case{"G0 X1 (a", "comment-unclosed", 7, 1},
                          Case{"(a (b) c) X1", "comment-nested", 4, 1},
                          Case{"G0 X1 X2", "word-twice", 7, 2},
                          Case{"G0 X9999999999999", "number-out-of-range", 4, 14},
                          Case{"G0 X[1+2", "bracket-unclosed", 5, 1},
                          Case{"G0 X[1 2 Y]", "operator-missing", 10, 1},
                          Case{"G0 X[1/0]", "no-result", 7, 2},
                          Case{"G0 X#<none>", "parameter-unset", 5, 7},
                          Case{"#1 (a)", "assignment-form", 1, 3},
                          Case{"O100 sup", "flow-keyword", 6, 3},
                          Case{"o<name call", "name-unclosed", 2, 10},
                          Case{"X1 o1 endif", "flow-not-first", 4, 1},
                          Case{"G0 N5", "n-not-first", 4, 1},
                          Case{"N-5 G0", "n-negative", 1, 3},
                          Case{"% G0", "percent-not-alone", 1, 1}}) {
        const Line line = lineOf(c.text);
        ASSERT_TRUE(line.error) << c.text;
        EXPECT_STREQ(line.error->message->id, c.id) << c.text;
        EXPECT_EQ(line.error->column, c.column) << c.text;
        EXPECT_EQ(line.error->length, c.length) << c.text;
    }
}

TEST(Lexer, HasRoomForEveryLegalBlockAndReportsMore) {
    std::string text;
    for (std::size_t i = 0; i < Block::kMostCodes; ++i)
        text += "G1 ";
    EXPECT_FALSE(lineOf(text).error);
    const Line full = lineOf(text + "M3");
    ASSERT_TRUE(full.error);
    EXPECT_STREQ(full.error->message->id, "too-many-codes");
}

TEST(Lexer, FindsTheAxesOfALineItCannotRead) {
    const LetterSet axes = axisLetters("G0 X[1] z# (Y5) ; Y");
    EXPECT_TRUE(axes.has('X'));
    EXPECT_TRUE(axes.has('Z'));
    EXPECT_FALSE(axes.has('Y'));
}

} // namespace proveout
