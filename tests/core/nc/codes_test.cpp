// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/codes.h"
#include "core/nc/run/interpreter.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

namespace proveout {

namespace {

const CodeTable& linuxcnc() {
    return codesOf(DialectId::linuxcnc);
}

} // namespace

TEST(Codes, AreSortedAndFoundByTheirNumber) {
    const auto before = [](const CodeRow& a, const CodeRow& b) {
        return std::tie(a.letter, a.tenths) < std::tie(b.letter, b.tenths);
    };
    const std::span<const CodeRow* const> rows = linuxcnc().rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const CodeRow& row = *rows[i];
        EXPECT_EQ(linuxcnc().find(row.letter, row.tenths), &row) << row.letter << row.tenths;
        EXPECT_FALSE(std::string_view(row.name).empty());
        EXPECT_TRUE(i == 0 || before(*rows[i - 1], row)) << row.letter << row.tenths;
    }
}

TEST(Codes, TakeEffectAtOneStepAGroup) {
    for (const CodeRow* one : linuxcnc().rows()) {
        const CodeRow& row = *one;
        EXPECT_EQ(row.supported(), row.step != Step::none) << row.letter << row.tenths;
        for (const CodeRow* another : linuxcnc().rows()) {
            const CodeRow& other = *another;
            // Two codes of different groups in the same step would overwrite each other in a block.
            if (row.supported() && other.supported() && row.step == other.step &&
                row.group != ModalGroup::motionOff && other.group != ModalGroup::motionOff) {
                EXPECT_EQ(row.group, other.group) << row.name << " / " << other.name;
            }
        }
    }
}

/// Expected values are the results of LinuxCNC's interpreter for every pair of codes.
TEST(Codes, ExcludeEachOtherAsLinuxCncHasThem) {
    const auto conflicts = [](const char* block) {
        const auto program = interpret(NcText(std::string("G21 F100 S100 M70\n") + block + "\nM2\n"));
        return std::ranges::any_of(program->diagnostics(), [](const Diagnostic& diagnostic) {
            return diagnostic.id == std::string("modal-conflict");
        });
    };
    for (const char* block : {"M70 M5", "M3 M71", "M4 M72", "M19 R1 M73", "M0 M99", "M99 M30", "M60 M99",
                              "G92.1 G92.2", "G4 G10 L2 P1 X0"})
        EXPECT_TRUE(conflicts(block)) << block;
    for (const char* block : {"G92.1 G4 P1", "G92.2 G10 L2 P1 X0", "G28 G92.3", "G92 X5 G92.1",
                              "G52 X1 G92.2", "M70 M8", "M3 M99"})
        EXPECT_FALSE(conflicts(block)) << block;
}

/// "G92 X5 G92.1" sets the shift for this block and then clears it.
TEST(Codes, EndAShiftAfterWhatTheBlockDoesOtherwise) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    const auto program = interpret(NcText("G21 G92 X5 G92.1\nG0 X1 Y0 Z0\nM2\n"), options);
    ASSERT_EQ(program->motionCount(), 1U);
    EXPECT_EQ(program->motion(0).end.x, 1);
}

TEST(Codes, SupportWhatIsListedHere) {
    const std::set<int> g{0,   10,  20,  30,  40,  50,  51,  52,  53,  70,  80,  330, 331, 382, 383, 384,
                          385, 960, 100, 170, 180, 190, 200, 210, 280, 281, 300, 301, 400, 410, 411, 420,
                          421, 430, 431, 432, 490, 520, 530, 540, 550, 560, 570, 580, 590, 591, 592, 593,
                          610, 611, 640, 730, 740, 800, 810, 820, 830, 840, 850, 860, 870, 880, 890, 900,
                          901, 910, 911, 920, 921, 922, 923, 930, 940, 950, 970, 980, 990};
    const std::set<int> m{0,   10,  20,  30,  40,  50,  60,  70,  80,  90,  190, 300, 480, 490, 500, 510, 520,
                          530, 600, 610, 620, 630, 640, 650, 660, 670, 680, 700, 710, 720, 730, 980, 990};
    for (const CodeRow* row : linuxcnc().rows())
        EXPECT_EQ(row->supported(), (row->letter == 'G' ? g : m).contains(row->tenths))
            << row->letter << row->tenths;
    for (const int tenths : g)
        EXPECT_NE(linuxcnc().find('G', tenths), nullptr) << tenths;
    for (const int tenths : m)
        EXPECT_NE(linuxcnc().find('M', tenths), nullptr) << tenths;
}

TEST(Codes, AreFoundByWords) {
    EXPECT_EQ(linuxcnc().find(Word{'G', 90.1, 1, 5}), linuxcnc().find('G', 901));
    EXPECT_EQ(linuxcnc().find(Word{'G', 38.2, 1, 5}), linuxcnc().find('G', 382));
    EXPECT_EQ(linuxcnc().find(Word{'G', 1.05, 1, 5}), nullptr);
    EXPECT_EQ(linuxcnc().find(Word{'G', -1, 1, 5}), nullptr);
    EXPECT_EQ(linuxcnc().find(Word{'G', 1e12, 1, 5}), nullptr);
    EXPECT_EQ(linuxcnc().find(Word{'X', 1, 1, 5}), nullptr);
    EXPECT_EQ(linuxcnc().find('G', 99999), nullptr);
}

TEST(Codes, ExplainEveryOtherLetter) {
    std::string letterRow;
    for (const LetterRow& row : letters())
        letterRow += row.letter;
    EXPECT_EQ(letterRow, "@ABCDEFHIJKLNOPQRSTUVWXYZ[]^_");
}

} // namespace proveout
