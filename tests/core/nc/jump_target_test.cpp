// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/jump_target.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/nc/text/word_scan.h"

namespace proveout {
namespace {

/// Where the word at index `at` of line `line` (0-based) leads: "line:begin-end"; "" for nowhere.
std::string ledTo(const std::string& text, std::size_t line, std::size_t at, DialectId dialect) {
    const NcText nc(text);
    const auto target = jumpTargetAt(nc.line(line), at, dialect);
    const auto place = target ? findTarget(nc, line, *target, dialect) : std::nullopt;
    return place ? fmt::format("{}:{}-{}", place->line, place->begin, place->end) : "";
}

TEST(JumpTarget, FindsBlocksAndProgramsOfMacros) {
    const std::string text =
        "O1\nN5 G1 X1.\nIF[#1GT3]GOTO 5\nM98 P30002\nG65 P3 A1.\nGOTO#1\nM97 P7 (P5)\nN7 M30\n"
        "O2\nN5 M99 P7\nO3\nWHILE[#1LT2]DO1\nG1\nEND1\nM99\n";
    const auto led = [&](std::size_t line, std::size_t at) { return ledTo(text, line, at, DialectId::haas); };
    EXPECT_EQ(led(2, 9), "1:0-2");
    EXPECT_EQ(led(2, 14), "1:0-2");
    EXPECT_EQ(led(3, 0), "8:0-2") << "O0002 three times";
    EXPECT_EQ(led(4, 5), "10:0-2");
    EXPECT_EQ(led(5, 1), "");
    EXPECT_EQ(led(6, 4), "7:0-2");
    EXPECT_EQ(led(6, 8), "") << "a comment";
    EXPECT_EQ(led(9, 7), "7:0-2") << "of the program that called";
    EXPECT_EQ(led(13, 0), "11:0-15");
    EXPECT_EQ(led(11, 13), "13:0-4");
    EXPECT_EQ(led(0, 99), "");
    EXPECT_EQ(ledTo(text, 3, 4, DialectId::grbl), "");
}

TEST(JumpTarget, FindsOWordsAndTheirPartners) {
    const std::string text =
        "o<a b> sub\no1 if [#1]\no1 else\no1 endif\no<AB> endsub\nO<ab> call [1]\no<x> call\n"
        "M98 P12\nM2\nO12\nM99\n";
    const auto led = [&](std::size_t line, std::size_t at) {
        return ledTo(text, line, at, DialectId::linuxcnc);
    };
    EXPECT_EQ(led(5, 2), "0:0-10");
    EXPECT_EQ(led(4, 1), "0:0-10");
    EXPECT_EQ(led(3, 0), "1:0-5");
    EXPECT_EQ(led(2, 0), "1:0-5");
    EXPECT_EQ(led(1, 0), "3:0-8");
    EXPECT_EQ(led(6, 2), "");
    EXPECT_EQ(led(7, 5), "9:0-3");
    const auto missing = jumpTargetAt("o<x> call", 2, DialectId::linuxcnc);
    ASSERT_TRUE(missing);
    EXPECT_EQ(filesOf(*missing, DialectId::linuxcnc), std::vector<std::string>{"x.ngc"});
    const auto outside = jumpTargetAt("o<../x> call", 2, DialectId::linuxcnc);
    ASSERT_TRUE(outside);
    EXPECT_TRUE(filesOf(*outside, DialectId::linuxcnc).empty());
}

TEST(JumpTarget, FindsAssignments) {
    const std::string text =
        "#5=1 (#5=2)\n#<Deep est>=3\nX#5 Y#<deepest>\n#05=#5+1\n#<deepest>=9\nZ##5 X#[#5]\n";
    const auto led = [&](std::size_t line, std::size_t at) {
        return ledTo(text, line, at, DialectId::linuxcnc);
    };
    EXPECT_EQ(led(2, 1), "0:0-2");
    EXPECT_EQ(led(2, 6), "1:0-11");
    EXPECT_EQ(led(3, 5), "0:0-2");
    EXPECT_EQ(led(4, 2), "1:0-11");
    EXPECT_EQ(led(5, 2), "3:0-3");
    EXPECT_EQ(ledTo("X#7\n#7=1\n", 0, 1, DialectId::fanuc), "1:0-2");
    EXPECT_EQ(ledTo("X#7\n", 0, 1, DialectId::fanuc), "");
}

TEST(WordScan, ReadsWordsAndComments) {
    const auto words = writtenWords("/N10 G 1 X-2.5(T1)Y#5 Z[T2] IF M6 ;T3");
    std::string shown;
    for (const WrittenWord& word : words)
        shown += fmt::format("{}{} ", word.letter, word.value ? fmt::format("{:g}", *word.value) : "?");
    EXPECT_EQ(shown, "N10 G1 X-2.5 Y? Z? M6 ");
    EXPECT_EQ(onlyComment(" /N5 ( a b ) "), "a b");
    EXPECT_EQ(onlyComment("(a"), "a");
    EXPECT_EQ(onlyComment("; a"), "a");
    EXPECT_EQ(onlyComment("(a) X1"), "");
    EXPECT_EQ(onlyComment("("), "");
    EXPECT_EQ(firstComment("T1 (a) (b)"), "a");
}

} // namespace
} // namespace proveout
