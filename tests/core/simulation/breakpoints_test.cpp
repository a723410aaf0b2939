// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/breakpoints.h"

#include <gtest/gtest.h>
#include <set>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

constexpr const char* kText = "T1 M6\n"       // 1
                              "G0 X5 Y5 Z5\n" // 2  block 0
                              "G1 Z-1 F300\n" // 3  block 1: first contact
                              "(a remark)\n"  // 4
                              "G1 X20\n"      // 5  block 2
                              "G1 Z-3 F500\n" // 6  block 3
                              "M0\n"          // 7
                              "G1 X30\n"      // 8  block 4
                              "G0 X10\n"      // 9  block 5: a rapid through material, along the slot above
                              "G0 Z5\n"       // 10 block 6
                              "T2 M6\n"       // 11
                              "G0 X20 Y20\n"  // 12 block 7
                              "G1 Z-2 F100\n" // 13 block 8: first contact
                              "G0 Z5\n"       // 14 block 9
                              "M30\n";

std::shared_ptr<const Setup> twoTools() {
    auto setup = std::make_shared<Setup>(*smallSetup());
    setup->tools.set(2, parseCutter("flat:d=6,l=20").value());
    return setup;
}

/// The number of executed blocks at each stop of a run.
std::vector<std::size_t> stops(const Breakpoint& breakpoint, const std::string& text = kText,
                               const std::shared_ptr<const Setup>& setup = twoTools()) {
    const auto program = programOf(text);
    const auto simulation = startedSimulation(program, setup, {});
    Breakpoints breakpoints;
    breakpoints.set({breakpoint}, *program, simulation->tools());
    std::vector<std::size_t> found;
    while (!simulation->atEnd()) {
        const std::size_t block = simulation->position();
        if (breakpoints.before(*program, block) != nullptr)
            found.push_back(block);
        simulation->step();
        if (breakpoints.after(*program, block, {simulation->rows(), simulation->findings().foundAt(block)}) !=
            nullptr)
            found.push_back(block + 1);
    }
    return found;
}

Breakpoint of(BreakpointKind kind) {
    Breakpoint breakpoint;
    breakpoint.kind = kind;
    return breakpoint;
}

using Blocks = std::vector<std::size_t>;

TEST(Breakpoints, StopBeforeALine) {
    const auto stopsAt = [](std::uint32_t line) {
        Breakpoint breakpoint;
        breakpoint.line = line;
        return stops(breakpoint);
    };
    EXPECT_EQ(stopsAt(5), Blocks{2});
    EXPECT_EQ(stopsAt(2), Blocks{0});
    EXPECT_EQ(stopsAt(4), Blocks{2}) << "the next that moves";
    EXPECT_EQ(stopsAt(7), Blocks{4});
    EXPECT_EQ(stopsAt(15), Blocks{}) << "nothing moves behind it";
    EXPECT_EQ(stopsAt(1000), Blocks{});
}

TEST(Breakpoints, StopEachTimeThatALineRunsAgain) {
    Breakpoint breakpoint;
    breakpoint.line = 3;
    EXPECT_EQ(stops(breakpoint, "G0 X0 Y0 Z5\no1 repeat [3]\nG1 X5 F100\nG1 X0\no1 endrepeat\nM30\n"),
              (Blocks{1, 3, 5}));
}

TEST(Breakpoints, StopBeforeTheSubprogramThatALineCalls) {
    const std::string text = "G0 X0 Y0 Z5\n"       // 1
                             "o1 call\n"           // 2
                             "S1000\n"             // 3
                             "G0 X2\n"             // 4  block 3
                             "M2\n"                // 5
                             "o1 sub\n"            // 6
                             "G1 X5 F100\nG1 X0\n" // 7, 8  blocks 1, 2
                             "o1 endsub\n";
    const auto stopsAt = [&](std::uint32_t line) {
        Breakpoint breakpoint;
        breakpoint.line = line;
        return stops(breakpoint, text);
    };
    EXPECT_EQ(stopsAt(2), Blocks{1});
    EXPECT_EQ(stopsAt(3), Blocks{3}) << "the next that moves";
    EXPECT_EQ(stopsAt(4), Blocks{3});
    EXPECT_EQ(stopsAt(8), Blocks{2});
}

TEST(Breakpoints, StopAtToolChangesAndStops) {
    EXPECT_EQ(stops(of(BreakpointKind::toolChange)), (Blocks{0, 7}));
    EXPECT_EQ(stops(of(BreakpointKind::programStop)), Blocks{4});
}

TEST(Breakpoints, StopBelowAHeightOnceOnTheWayDown) {
    Breakpoint breakpoint = of(BreakpointKind::zBelow);
    breakpoint.z = -1.5;
    EXPECT_EQ(stops(breakpoint), (Blocks{3, 8}));
    breakpoint.z = -3;
    EXPECT_EQ(stops(breakpoint), Blocks{}) << "at it is not below it";
    breakpoint.z = -4;
    EXPECT_EQ(stops(breakpoint, "G0 X0 Y0 Z0\nG18 G2 X10 Z0 I5 K0 F100\nG3 X0 Z0 I-5 K0\n"), (Blocks{1, 2}))
        << "in the middle of an arc";
}

TEST(Breakpoints, StopAfterFirstContactsAndFaults) {
    EXPECT_EQ(stops(of(BreakpointKind::firstContact)), (Blocks{2, 9}));
    EXPECT_EQ(stops(of(BreakpointKind::fault), "T1 M6\nG0 X5 Y5 Z5\nG0 Z-2\nG1 X20 F300\nG0 X30\nG0 Z5\n"),
              (Blocks{2, 4}));
}

TEST(Breakpoints, StopWhereAConditionBeginsToHold) {
    const auto stopsAt = [](const char* text) {
        Breakpoint breakpoint = of(BreakpointKind::condition);
        breakpoint.condition = text;
        return stops(breakpoint);
    };
    EXPECT_EQ(stopsAt("Z < -2"), Blocks{3});
    EXPECT_EQ(stopsAt("Z < -0.5 && T == 2"), Blocks{8});
    EXPECT_EQ(stopsAt("F >= 500"), Blocks{3});
    EXPECT_EQ(stopsAt("N == 5 || L == 13"), (Blocks{4, 8}));
    EXPECT_EQ(stopsAt("X >= 0"), Blocks{0});
    EXPECT_EQ(stopsAt("no condition"), Blocks{});
}

/// Works for a tool that is assumed to be in the spindle too.
TEST(Breakpoints, KnowTheToolOfAProgramThatCallsNone) {
    Breakpoint breakpoint = of(BreakpointKind::condition);
    breakpoint.condition = "T == 1 && Z < 0";
    const char* const uncalled = "G0 X5 Y5 Z5\nG1 Z-1 F300\nX20\n";
    EXPECT_EQ(stops(breakpoint, uncalled, smallSetup()), Blocks{1});
    EXPECT_EQ(stops(breakpoint, uncalled, twoTools()), Blocks{}) << "it could be either";
}

TEST(Breakpoints, ThatAreOffNeverStop) {
    Breakpoint breakpoint = of(BreakpointKind::toolChange);
    breakpoint.enabled = false;
    EXPECT_EQ(stops(breakpoint), Blocks{});
}

TEST(Breakpoints, HaveOneRowAKind) {
    std::set<std::string> keys;
    for (const BreakpointRow& row : breakpointRows()) {
        EXPECT_EQ(&rowOf(row.kind), &row);
        EXPECT_NE(row.before == nullptr, row.after == nullptr) << row.key;
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    }
}

} // namespace
} // namespace proveout
