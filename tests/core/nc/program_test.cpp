// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/program/program.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "core/nc/run/interpreter.h"
#include "tests/core/nc/random_arc.h"
#include "tests/random_seed.h"

namespace proveout {

using test::randomArc;
using test::uniform;

namespace {

Motion randomMotion(std::mt19937& random, const Vec3& start) {
    Motion motion;
    if (random() % 3 == 0) {
        motion = randomArc(random, 0.01);
    } else {
        motion.kind = random() % 2 == 0 ? MotionKind::rapid : MotionKind::feed;
        motion.start = start;
        motion.end = Vec3(uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, -9, 9));
    }
    motion.startKnown = static_cast<std::uint8_t>(random() % 8);
    motion.endKnown = static_cast<std::uint8_t>(random() % 8);
    motion.unverified = random() % 2 == 0;
    motion.tool = static_cast<int>(random() % 3);
    motion.line = static_cast<std::uint32_t>(random() % 1000);
    motion.feedMmPerMin = static_cast<double>(random() % 5000);
    motion.spindleRpm = static_cast<double>(random() % 3) * -1000;
    motion.orderedRpm = -motion.spindleRpm;
    return motion;
}

void expectSame(const Motion& a, const Motion& b) {
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.startKnown, b.startKnown);
    EXPECT_EQ(a.endKnown, b.endKnown);
    EXPECT_EQ(a.unverified, b.unverified);
    EXPECT_EQ(a.tool, b.tool);
    EXPECT_EQ(a.line, b.line);
    EXPECT_EQ(a.start, b.start);
    EXPECT_EQ(a.end, b.end);
    EXPECT_EQ(a.feedMmPerMin, b.feedMmPerMin);
    EXPECT_EQ(a.spindleRpm, b.spindleRpm);
    EXPECT_EQ(a.orderedRpm, b.orderedRpm);
    if (a.kind == MotionKind::arc) {
        EXPECT_EQ(a.plane, b.plane);
        EXPECT_EQ(a.centre, b.centre);
        EXPECT_EQ(a.sweep, b.sweep);
    }
}

/// The runs of `program`, each as "TOOL:FIRST-LAST", found by visiting every motion.
std::string runsByHand(const Program& program) {
    std::string out;
    for (std::size_t first = 0, i = 0; i < program.motionCount(); ++i) {
        const int tool = program.motion(i).tool;
        if (i + 1 < program.motionCount() && program.motion(i + 1).tool == tool)
            continue;
        out += std::to_string(tool) + ":" + std::to_string(first) + "-" + std::to_string(i + 1) + " ";
        first = i + 1;
    }
    return out;
}

std::string runs(const Program& program) {
    std::string out;
    for (const auto& [tool, first, last] : program.toolRuns())
        out += std::to_string(tool) + ":" + std::to_string(first) + "-" + std::to_string(last) + " ";
    return out;
}

std::shared_ptr<const Program> programOf(const std::string& text) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    return interpret(NcText(text), options);
}

} // namespace

TEST(Program, GivesBackTheMotionsItWasGiven) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        Program program;
        std::vector<Motion> motions;
        Box3 box;
        Vec3 at(0);
        for (int i = 0; i < 200; ++i) {
            if (random() % 10 == 0)
                at += Vec3(1, 0, 0); // a jump in the path
            motions.push_back(randomMotion(random, at));
            at = motions.back().end;
            program.append(motions.back());
            if (motions.back().known())
                box.add(bounds(motions.back()));
        }
        ASSERT_EQ(program.motionCount(), motions.size());
        for (std::size_t i = 0; i < motions.size(); ++i)
            expectSame(program.motion(i), motions[i]);
        EXPECT_EQ(program.bounds().lo, box.lo);
        EXPECT_EQ(program.bounds().hi, box.hi);
    }
}

TEST(Program, ReportsTheRunsOfEachTool) {
    EXPECT_EQ(runs(*programOf("M2\n")), "");
    EXPECT_EQ(runs(*programOf("G0 X1\nT1 M6\nG0 X2\nS100 M3\nX3\nS200\nX4\nT2 M6\nT0 M6\nX5\nT1 M6\nX6\n")),
              "0:0-1 1:1-4 0:4-5 1:5-6 ");
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 100; ++round) {
        Program program;
        for (auto line = static_cast<std::uint32_t>(random() % 200); line > 0; --line) {
            program.beginBlock(line);
            program.append(randomMotion(random, Vec3(0)));
        }
        EXPECT_EQ(runs(program), runsByHand(program));
    }
}

TEST(Program, CountsTheBlocksThatMove) {
    const auto program = programOf("G21\n(a)\nG0 X1\nG90\nX2\n\nM2\n");
    ASSERT_EQ(program->blockCount(), 2U);
    EXPECT_EQ(program->sourceBlockCount(), 5U) << "a comment alone is no block";
    EXPECT_EQ(program->blockLine(0), 3U);
    EXPECT_EQ(program->blockLine(1), 5U);
    EXPECT_EQ(program->blockMotions(1).first, 1U);
    EXPECT_EQ(program->blockMotions(1).last, 2U);
    const std::vector<std::size_t> after{0, 0, 0, 1, 1, 2, 2, 2, 2};
    for (std::uint32_t line = 0; line < after.size(); ++line)
        EXPECT_EQ(program->blocksAfterLine(line), after[line]) << line;
}

TEST(Program, TakesTheFirstExecutionOfALine) {
    Program program;
    for (const std::uint32_t line : {5U, 2U, 3U, 2U, 3U, 6U}) {
        program.beginLine(line, 0);
        program.beginBlock(line);
        program.append(Motion{});
    }
    EXPECT_EQ(program.blocksAfterLine(2), 2U);
    EXPECT_EQ(program.blocksAfterLine(3), 3U);
    EXPECT_EQ(program.blocksAfterLine(5), 1U);
    EXPECT_EQ(program.blocksAfterLine(6), 6U);
    EXPECT_EQ(program.blocksAfterLine(9), 6U);
}

TEST(Program, FindsTheFirstBlockThatMovesOtherwise) {
    const std::string text = "T1 M6\nG0 X1\nG1 Y1 F100\nG2 X2 I.5\nX3 I.5\nT2 M6\nG1 X9\nM2\n";
    const auto program = programOf(text);
    const auto differenceTo = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        changed.replace(changed.find(from), from.size(), to);
        const auto other = programOf(changed);
        EXPECT_EQ(program->firstDifference(*other), other->firstDifference(*program));
        return program->firstDifference(*other);
    };
    ASSERT_EQ(program->blockCount(), 5U);
    EXPECT_EQ(program->firstDifference(*programOf(text)), 5U);
    EXPECT_EQ(differenceTo("G0 X1\n", "G0 X1 (a comment)\n\n"), 5U);
    EXPECT_EQ(differenceTo("F100", "F200"), 5U) << "the feed moves nothing";
    EXPECT_EQ(differenceTo("G0 X1", "G0 X1.1"), 0U);
    EXPECT_EQ(differenceTo("G1 Y1", "G0 Y1"), 1U) << "a rapid cuts, and is a finding";
    EXPECT_EQ(differenceTo("G2 X2 I.5", "G3 X2 I.5"), 2U);
    EXPECT_EQ(differenceTo("G2 X2 I.5", "G2 X2 R.501"), 2U) << "the same ends, another arc";
    EXPECT_EQ(differenceTo("X3 I.5\n", "X3 I.5\nX4 I.5\n"), 4U);
    EXPECT_EQ(differenceTo("X3 I.5\n", ""), 3U);
    EXPECT_EQ(differenceTo("T2", "T3"), 4U);
    EXPECT_EQ(differenceTo("G1 X9\n", ""), 4U);
}

TEST(Program, FindsTheFirstBlockThatEndsElsewhereAboveTheMachinesZero) {
    const std::string text = "T1 M6\nG0 X20 Y15 Z5\nG53 G0 Z0\nG0 X5 Y5\nM2\n";
    const auto program = programOf(text);
    std::string lower = text;
    lower.replace(lower.find("G53 G0 Z0"), 9, "G53 G0 Z-100");
    EXPECT_EQ(program->firstDifference(*programOf(lower)), 1U) << "a finding depends on it";
    EXPECT_EQ(program->firstDifference(*programOf(text)), program->blockCount());
}

TEST(Program, KnowsWhenItsStartDiffers) {
    InterpretOptions there;
    there.start = Vec3(1, 0, 0);
    InterpretOptions here;
    here.start = Vec3(0);
    const NcText text("G0 X5\nX6\n");
    EXPECT_EQ(interpret(text, here)->firstDifference(*interpret(text, there)), 0U);
}

TEST(Program, CutBackIsTheProgramAsItWas) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 50; ++round) {
        Program program;
        Program::Extent extent;
        const auto kept = static_cast<unsigned>(random() % 40);
        Vec3 at(0);
        const auto grow = [&](unsigned count) {
            for (unsigned i = 0; i < count; ++i) {
                const Motion motion = randomMotion(random, at);
                program.beginBlock(motion.line);
                if (random() % 3 == 0)
                    program.append(Dwell{1}, motion.line);
                if (random() % 4 == 0)
                    program.appendCompensated(motion, motion.end);
                else
                    program.append(motion);
                at = motion.end;
            }
        };
        grow(kept);
        extent = program.extent();
        const Program whole = program;
        grow(static_cast<unsigned>(random() % 40));
        program.append(Diagnostic{Severity::error, true, "id", "text", {}, "", "", {1, 1, 0}});
        program.cutBack(extent);
        Program expected = whole;
        expected.settle();
        ASSERT_EQ(program.motionCount(), kept);
        EXPECT_EQ(program.blockCount(), whole.blockCount());
        EXPECT_EQ(program.events().size(), whole.events().size());
        for (const auto box : {&Program::bounds, &Program::cuttingBounds}) {
            EXPECT_EQ((program.*box)().lo, (expected.*box)().lo);
            EXPECT_EQ((program.*box)().hi, (expected.*box)().hi);
        }
        EXPECT_EQ(program.firstDifference(expected), expected.blockCount());
        EXPECT_LE(program.motionAfterDiagnostic(0), kept);
        EXPECT_LE(program.bytes(), whole.bytes());
    }
}

} // namespace proveout
