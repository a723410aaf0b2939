// SPDX-License-Identifier: GPL-3.0-or-later
// The tool in the spindle before the program calls one, and T0.
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string_view>

#include "core/simulation/run/interpretation.h"
#include "core/simulation/setup/tool_choice.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kCut = "G0 X5 Y5 Z5\nG1 Z-2 F100\nX30\n";

struct Outcome {
    Frame frame;
    std::vector<std::string> ids;

    [[nodiscard]] std::string firstMessage() const { return message(frame.findings.front()); }
};

std::shared_ptr<Setup> setupOf(std::vector<int> tools, std::optional<int> start,
                               std::optional<DialectId> dialect = DialectId::linuxcnc) {
    auto setup = std::make_shared<Setup>(*smallSetup());
    setup->tools = {};
    for (const int number : tools)
        setup->tools.set(number, parseCutter("flat:d=4,l=20").value());
    setup->startTool = start;
    setup->dialect = dialect;
    return setup;
}

bool speaksOf(const Program& program, std::string_view id) {
    return std::ranges::any_of(program.diagnostics(), [&](const Diagnostic& each) { return id == each.id; });
}

/// Interprets the text with the setup, and runs it to the end.
Outcome run(const std::string& text, const std::shared_ptr<const Setup>& setup) {
    const auto program = interpretOn(*setup, NcText(text), interpretOptions(*setup, {}));
    const auto simulation = startedSimulation(program, setup, {});
    simulation->seek(simulation->blockCount());
    Outcome done{simulation->frame(), {}};
    for (const Diagnostic& finding : done.frame.findings)
        done.ids.emplace_back(finding.id);
    return done;
}

TEST(StartTool, OneThatIsSetCutsWhatComesBeforeTheFirstChange) {
    const Outcome set = run(kCut, setupOf({1, 2}, 2));
    EXPECT_GT(set.frame.removedMm3, 0);
    EXPECT_EQ(set.frame.tool, 2);
    EXPECT_FALSE(set.frame.toolAssumed);
    EXPECT_THAT(set.ids, IsEmpty());
    const Outcome changed = run(kCut + "G0 Z5\nT1 M6\nG0 X5 Y20\nG1 Z-1\n", setupOf({1, 2}, 2));
    EXPECT_EQ(changed.frame.tool, 1);
    EXPECT_THAT(changed.ids, IsEmpty());
}

TEST(StartTool, OneThatIsNotInTheTableIsMissed) {
    EXPECT_THAT(run(kCut, setupOf({1, 2}, 7)).ids, ElementsAre("tool-undefined"));
    EXPECT_THAT(run(kCut, setupOf({1, 2}, 0)).ids, ElementsAre("no-tool")) << "an empty spindle";
}

TEST(StartTool, TheOnlyToolOfTheTableIsAssumedUntilItIsSet) {
    const Outcome assumed = run(kCut, setupOf({5}, {}));
    EXPECT_GT(assumed.frame.removedMm3, 0);
    EXPECT_TRUE(assumed.frame.toolAssumed);
    EXPECT_THAT(assumed.ids, ElementsAre("tool-assumed"));
    EXPECT_TRUE(assumed.frame.findings.front().unverified) << "nothing found on an assumption is safe";
    EXPECT_THAT(run(kCut, setupOf({5}, 5)).ids, IsEmpty());
    EXPECT_THAT(run(kCut, setupOf({5}, 0)).ids, ElementsAre("no-tool")) << "said to be empty";
    EXPECT_THAT(run(kCut, setupOf({5, 6}, {})).ids, ElementsAre("no-tool"));
    EXPECT_THAT(run(kCut + "T5 M6\nG1 X5\n", setupOf({5}, {})).ids, ElementsAre("no-tool"))
        << "what it calls later need not be what was in it before";
}

TEST(StartTool, IsShownBeforeTheFirstBlock) {
    const auto program = programOf(kCut);
    EXPECT_EQ(startedSimulation(program, setupOf({1, 2}, 2), {})->frame().tool, 2);
    const Frame assumed = startedSimulation(program, setupOf({5}, {}), {})->frame();
    EXPECT_EQ(assumed.tool, 5);
    EXPECT_TRUE(assumed.toolAssumed);
}

/// The control knows the start tool too: G43 without H uses the length of the tool in the spindle, G41
/// without D its diameter.
TEST(StartTool, IsThatOfCutterCompensation) {
    const std::string text = "G0 X0 Y-20 Z5\nG41 G1 X0 Y0 F100\nY20\nY40\nG40\nM2\n";
    const auto end = [&](std::optional<int> start) {
        const auto setup = setupOf({1, 2}, start);
        return interpret(NcText(text), interpretOptions(*setup, {}))->motion(2).end.x;
    };
    EXPECT_NEAR(end(2), -2, 1e-9);
    EXPECT_NEAR(end({}), 0, 1e-9);
    const auto program = programOf(text);
    EXPECT_FALSE(interpretedAlike(*program, *setupOf({1, 2}, 2), *setupOf({1, 2}, {})));
}

const std::string kCompensated = "G0 X5 Y5 Z5\nG1 Z-1 F100\nG41 G1 X20 Y10\nY20\nY25\nG40 X25\n";

/// With an assumed tool, compensation uses that tool: 2 mm left of the programmed path.
TEST(StartTool, ThatIsAssumedIsThatOfCutterCompensation) {
    const auto read = [](const std::vector<int>& tools, std::optional<int> start, const std::string& text) {
        const auto setup = setupOf(tools, start);
        return interpretOn(*setup, NcText(text), interpretOptions(*setup, {}));
    };
    const auto assumed = read({5}, {}, kCompensated);
    EXPECT_NEAR(assumed->motion(3).end.x, 18, 1e-9);
    EXPECT_FALSE(speaksOf(*assumed, "compensation-without-diameter"));
    EXPECT_TRUE(speaksOf(*read({5}, 0, kCompensated), "compensation-without-diameter"));
    EXPECT_EQ(assumed->firstDifference(*read({5}, 5, kCompensated)), assumed->blockCount());
    EXPECT_NEAR(read({5, 6}, {}, kCompensated)->motion(3).end.x, 20, 1e-9) << "nothing is assumed";
    EXPECT_NEAR(read({5}, 0, kCompensated)->motion(3).end.x, 20, 1e-9) << "said to be empty";
    EXPECT_NEAR(read({5}, {}, kCompensated + "T5 M6\n")->motion(3).end.x, 20, 1e-9)
        << "what it calls later need not be what was in it before";
    const Outcome done = run(kCompensated, setupOf({5}, {}));
    EXPECT_TRUE(done.frame.toolAssumed);
    EXPECT_EQ(done.frame.tool, 5);
    EXPECT_THAT(done.ids, ElementsAre("tool-assumed"));
}

/// A program that is interpreted again to inspect one of its blocks is the same program.
TEST(StartTool, ThatIsAssumedIsTheSameInALookBack) {
    const auto setup = setupOf({5}, {});
    const auto program = interpretOn(*setup, NcText(kCompensated), interpretOptions(*setup, {}));
    InterpretOptions options = interpretOptions(*setup, {}, *program);
    EXPECT_EQ(options.startTool, 5);
    options.stopAfterBlocks = 4;
    EXPECT_NEAR(interpret(NcText(kCompensated), options)->motion(3).end.x, 18, 1e-9);
    const auto plain = interpretOn(*setup, NcText(kCut), interpretOptions(*setup, {}));
    EXPECT_EQ(interpretOptions(*setup, {}, *plain).startTool, 0) << "it asks for no tool";
}

TEST(StartTool, IsSpokenOfByWhatTheProgramCalls) {
    EXPECT_THAT(run(kCut, setupOf({5}, {})).firstMessage(),
                testing::HasSubstr("calls no tool; T5 is assumed"));
    EXPECT_THAT(run(kCut, setupOf({5, 6}, {})).firstMessage(),
                testing::HasSubstr("calls no tool; its moves"));
    EXPECT_THAT(run(kCut + "T5 M6\nG1 X5\n", setupOf({5}, {})).firstMessage(),
                testing::HasSubstr("cuts before it calls a tool; moves"));
    EXPECT_THAT(run(kCut + "T1 M6\nG1 X5\n", setupOf({0, 1}, {})).firstMessage(),
                testing::HasSubstr("cuts before it calls a tool; T0 is assumed"));
}

/// "T0 M6" returns the tool to the magazine: on LinuxCNC (its manual, "tool table": T0 means no tool, except
/// with a random tool changer, where it is a normal tool), on Fanuc, Haas and Mach. So T0 is the cutter in
/// the tool table, or otherwise an empty spindle.
TEST(ToolZero, IsACutterWhereTheTableHasItAndElseAnEmptySpindle) {
    for (const DialectId dialect :
         {DialectId::linuxcnc, DialectId::fanuc, DialectId::haas, DialectId::mach}) {
        const std::string text = "G21 G90\nT0 M6\nG0 X5. Y5. Z5.\nG1 Z-2. F100.\nX30.\n";
        const Outcome cutter = run(text, setupOf({0, 1}, {}, dialect));
        EXPECT_GT(cutter.frame.removedMm3, 0);
        EXPECT_THAT(cutter.ids, IsEmpty());
        const Outcome empty = run(text, setupOf({1}, {}, dialect));
        EXPECT_EQ(empty.frame.removedMm3, 0);
        EXPECT_THAT(empty.ids, ElementsAre("no-tool"));
        EXPECT_THAT(message(empty.frame.findings.front()), testing::HasSubstr("T0"));
        // The spindle is emptied at the end, on the way home, so no tool is missing.
        EXPECT_THAT(run("G21 G90\nT1 M6\nG0 X5. Y5. Z5.\nG1 Z-2. F100.\nG0 Z5.\nT0 M6\nG0 X0. Y0.\n",
                        setupOf({1}, {}, dialect))
                        .ids,
                    IsEmpty());
    }
}

/// grbl has no tool change: T does not affect the spindle, so T0 does not indicate a missing tool.
TEST(ToolZero, SaysNothingOnGrbl) {
    const std::string text = "G21 G90\nT0\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30\n";
    const auto setup = setupOf({1}, 1, DialectId::grbl);
    const auto program = interpret(NcText(text), interpretOptions(*setup, {}));
    EXPECT_FALSE(program->unverified());
    EXPECT_THAT(run(text, setup).ids, IsEmpty());
}

/// A post processor that writes "T0 : 3.175" and never calls a tool: the control's tool number before any
/// call is 0.
TEST(ToolZero, OfTheTableIsAssumedWhereNoToolIsCalledBeforeTheFirstCut) {
    const Outcome assumed = run(kCut, setupOf({0, 1}, {}));
    EXPECT_GT(assumed.frame.removedMm3, 0);
    EXPECT_TRUE(assumed.frame.toolAssumed);
    EXPECT_THAT(assumed.ids, ElementsAre("tool-assumed"));
    EXPECT_THAT(run("G0 Z5\nT1 M6\nG0 X5 Y5\nG1 Z-2 F100\n", setupOf({0, 1}, {})).ids, IsEmpty())
        << "rapids on the way to the first tool assume nothing";
    EXPECT_THAT(run(kCut, setupOf({0, 1}, 0)).ids, IsEmpty()) << "T0 was set";
}

} // namespace
} // namespace proveout
