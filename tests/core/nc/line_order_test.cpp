// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks before and after the first execution of each line, against values counted by hand.
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/nc/run/interpreter.h"
#include "tests/core/nc/program_invariants.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

using testing::ElementsAre;
using Counts = std::vector<std::size_t>;

/// For the lines from 1 to the one after the last.
struct Order {
    Counts before;
    Counts after;
};

Order orderOf(const std::string& text, const InterpretOptions& options = {}) {
    const NcText lines(text);
    const auto program = interpret(lines, options);
    Order order;
    for (std::uint32_t line = 1; line <= lines.lineCount(); ++line) {
        order.before.push_back(program->blocksBeforeLine(line));
        order.after.push_back(program->blocksAfterLine(line));
    }
    return order;
}

InterpretOptions fanuc() {
    InterpretOptions options;
    options.dialect = DialectId::fanuc;
    return options;
}

TEST(LineOrder, OfACallIncludesTheSubprogramBelowTheProgram) {
    const Order order = orderOf("O1\n"       // 1
                                "G0 X1.\n"   // 2
                                "M98 P100\n" // 3
                                "S100\n"     // 4
                                "G0 X2.\n"   // 5
                                "M30\n"      // 6
                                "O100\n"     // 7
                                "G0 X5.\n"   // 8
                                "G0 X6.\n"   // 9
                                "M99\n",     // 10
                                fanuc());
    EXPECT_THAT(order.before, ElementsAre(0, 0, 1, 3, 3, 4, 1, 1, 2, 3, 4));
    EXPECT_THAT(order.after, ElementsAre(0, 1, 3, 3, 4, 4, 1, 2, 3, 3, 4));
}

TEST(LineOrder, OfACallIncludesTheWholeFile) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "deep.ngc") << "o<deep> sub\nG0 X5\nG0 X6\no<deep> endsub\nM2\n";
    std::ofstream(folder.path() / "other.ngc")
        << "o<other> sub\nG0 Y5\no<deep> call\nG0 Y6\no<other> endsub\nM2\n";
    InterpretOptions options;
    options.subprogramFolders = {folder.path()};
    const Order order = orderOf("G0 X1\n"         // 1
                                "o<other> call\n" // 2
                                "S1\n"            // 3
                                "o<deep> call\n"  // 4
                                "o<deep> call\n"  // 5
                                "G0 X2\n"         // 6
                                "M2\n",           // 7
                                options);
    EXPECT_THAT(order.before, ElementsAre(0, 1, 5, 5, 7, 9, 10, 10));
    EXPECT_THAT(order.after, ElementsAre(1, 5, 5, 7, 9, 10, 10, 10));
}

TEST(LineOrder, OfNestedCallsThatAreRepeated) {
    const Order order = orderOf("O1\n"         // 1
                                "M98 P20 L2\n" // 2
                                "G0 X2.\n"     // 3
                                "M98 P30\n"    // 4
                                "M30\n"        // 5
                                "O20\n"        // 6
                                "M98 P30\n"    // 7
                                "S5\n"         // 8
                                "G0 X3.\n"     // 9
                                "M99\n"        // 10
                                "O30\n"        // 11
                                "G0 X4.\n"     // 12
                                "M99\n",       // 13
                                fanuc());
    EXPECT_THAT(order.before, ElementsAre(0, 0, 4, 5, 6, 0, 0, 1, 1, 2, 0, 0, 1, 6));
    EXPECT_THAT(order.after, ElementsAre(0, 4, 5, 6, 6, 0, 1, 1, 2, 2, 0, 1, 1, 6));
}

TEST(LineOrder, IsThatOfTheFirstRoundOfALoop) {
    const Order order = orderOf("#1=0\n"               // 1
                                "o1 while [#1 LT 3]\n" // 2
                                "G0 X#1\n"             // 3
                                "#1=[#1+1]\n"          // 4
                                "o1 endwhile\n"        // 5
                                "o2 if [0]\n"          // 6
                                "G0 X8\n"              // 7
                                "o2 endif\n"           // 8
                                "G0 X9\n"              // 9
                                "M2\n");               // 10
    EXPECT_THAT(order.before, ElementsAre(0, 0, 0, 1, 1, 3, 3, 3, 3, 4, 4));
    EXPECT_THAT(order.after, ElementsAre(0, 0, 1, 1, 1, 3, 3, 3, 4, 4, 4));
}

TEST(LineOrder, OfALineThatNeverEndsIsTheWholeProgram) {
    const Order order = orderOf("M98 P100\n" // 1
                                "G0 X2.\n"   // 2
                                "O100\n"     // 3
                                "G0 X5.\n"   // 4
                                "M30\n",     // 5
                                fanuc());
    EXPECT_THAT(order.after, ElementsAre(1, 0, 0, 1, 1, 1));
}

TEST(LineOrder, OfACallThatTheLimitOfMotionsStopsIsTheWholeProgram) {
    const NcText text("M98 P100 L2\n" // 1
                      "G0 X2.\n"      // 2
                      "M30\n"         // 3
                      "O100\n"        // 4
                      "G0 X5.\n"      // 5
                      "G0 X6.\n"      // 6
                      "M99\n");       // 7
    InterpretOptions options = fanuc();
    options.maxMotions = 1;
    const auto program = interpret(text, options);
    EXPECT_EQ(program->blocksAfterLine(1), program->blockCount());
    EXPECT_EQ(test::brokenPromise(text, options, *program), "");
}

} // namespace
} // namespace proveout
