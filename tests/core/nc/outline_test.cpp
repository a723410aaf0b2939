// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/outline.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace proveout {
namespace {

/// One line for each section: indented, with its name, comment and lines.
std::string outlined(const std::string& text, DialectId dialect) {
    std::string shown;
    for (const Section& section : outlineOf(NcText(text), dialect))
        shown += fmt::format("{}{}({}) {}-{}\n", std::string(section.depth, ' '), section.name,
                             section.comment, section.line, section.lastLine);
    return shown;
}

TEST(Outline, IsByProgramToolAndOperation) {
    EXPECT_EQ(
        outlined(
            "%\nO1 (PART)\n(HEADING)\nG21\n(DRILL)\nT1\nM6\n(HOLES)\n(two)\nN5 G1 X1.\nGOTO 5\n\n(BORE)\nG1\n"
            "(END MILL)\nT2 M6\nG1\nM30\nO2\nM99\n",
            DialectId::fanuc),
        "O1(PART) 1-17\n T1() 6-14\n  HOLES() 7-11\n   N5() 9-9\n  BORE() 12-14\n T2(END MILL) 15-17\nO2() "
        "18-20\n");
}

TEST(Outline, HasSubprogramsWhereTheyAre) {
    EXPECT_EQ(
        outlined("G21\nT5 M6 (D8)\no<probe> sub (finds the edge)\nG1\n(touch)\nG1\no<probe> endsub\nG1\n",
                 DialectId::linuxcnc),
        "T5(D8) 1-8\n probe(finds the edge) 2-6\n  touch() 4-6\n");
    EXPECT_EQ(outlined("G0 X1\nT1\nG0\nT#3\nG0\n", DialectId::linuxcnc), "T1() 1-2\nT?() 3-5\n");
    EXPECT_EQ(outlined("", DialectId::linuxcnc), "");
}

TEST(Outline, IsBounded) {
    std::string text;
    for (std::size_t k = 0; k < kMostSections + 10; ++k)
        text += "G1 X1\n(cut)\n";
    EXPECT_EQ(outlineOf(NcText(text), DialectId::linuxcnc).size(), kMostSections);
}

} // namespace
} // namespace proveout
