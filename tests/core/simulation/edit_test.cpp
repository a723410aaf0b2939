// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <sstream>
#include <vector>

#include "core/simulation/run/rim_finder.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const auto& line : lines)
        text += line + "\n";
    return text;
}

/// Replaces, removes or adds a line after the head of the program.
std::string edited(const std::string& text, std::mt19937& random) {
    auto lines = linesOf(text);
    const auto at = static_cast<std::ptrdiff_t>(4 + random() % (lines.size() - 5));
    switch (random() % 4) {
    case 0:
        lines[static_cast<std::size_t>(at)] = "G1 X20 Y15 Z-5 F500";
        break;
    case 1:
        lines.erase(lines.begin() + at);
        break;
    case 2:
        lines.insert(lines.begin() + at, "G1 X10 Y25 Z-6 F500");
        break;
    default:
        lines.insert(lines.begin() + at, "(a remark changes no block)");
    }
    return joined(lines);
}

std::string sentences(const Diagnostics& diagnostics) {
    std::string text;
    for (const auto& diagnostic : diagnostics)
        text += oneLine(diagnostic) + "\n";
    return text;
}

TEST(Edit, ContinuesLikeAFreshRun) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::string text = randomProgram(random(), 80);
    const auto setup = smallSetup();
    const auto simulation = startedSimulation(programOf(text), setup, {});
    for (int edit = 0; edit < 25; ++edit) {
        SCOPED_TRACE(testing::Message() << "edit " << edit);
        simulation->seek(random() % (simulation->blockCount() + 1));
        const std::size_t before = simulation->position();
        const auto old = programOf(text);
        text = edited(text, random);
        const auto program = programOf(text);
        apply(*simulation, program);

        const auto fresh = straightRun(program, setup, {});
        ASSERT_EQ(simulation->position(), std::min(before, old->firstDifference(*program)));
        ASSERT_EQ(difference(simulation->frame(), fresh[simulation->position()]), "");
        simulation->seek(simulation->blockCount());
        const Frame frame = simulation->frame();
        ASSERT_EQ(difference(frame, fresh.back()), "");
        EXPECT_EQ(sentences(frame.findings), sentences(fresh.back().findings));
        for (std::size_t row = 0; row < frame.statistics.size(); ++row) {
            const BlockStatistics& wanted = fresh.back().statistics[row];
            EXPECT_EQ(frame.statistics[row].removedMm3, wanted.removedMm3) << "row " << row;
            EXPECT_EQ(frame.statistics[row].maxDepth, wanted.maxDepth) << "row " << row;
            EXPECT_EQ(frame.statistics[row].radialEngagement, wanted.radialEngagement) << "row " << row;
            EXPECT_EQ(frame.statistics[row].facesFull, wanted.facesFull) << "row " << row;
        }
        simulation->play(simulation->blockCount());
        const auto& rows = simulation->rows();
        ASSERT_EQ(rows.size(), fresh.back().statistics.size());
        for (std::size_t row = 0; row < rows.size(); ++row)
            EXPECT_EQ(outcome(rows[row]), outcome(fresh.back().statistics[row])) << "row " << row;
    }
}

/// Counts blocks, including replays, and not seconds. The deep blocks at the beginning leave mostly air cuts
/// for the others, so checkpoints by cutting time alone would be too far apart.
TEST(Edit, InTheLastTenthCutsAtMostFifteenPercentOfTheBlocks) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const auto setup = smallSetup(0.03);
    DecimationParameters parameters;
    parameters.period = 0;
    auto lines = linesOf(randomProgram(seed, roundsOf(3000)));
    const auto simulation = startedSimulation(programOf(joined(lines)), setup, parameters);
    simulation->seek(simulation->blockCount());
    for (const std::size_t percent : {98, 95, 91}) {
        SCOPED_TRACE(testing::Message() << "at " << percent << " %");
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(lines.size() * percent / 100),
                     "G1 X20 Y15 Z-5 F500");
        const auto program = programOf(joined(lines));
        ASSERT_GT(simulation->program().firstDifference(*program), program->blockCount() * 9 / 10);
        const std::size_t before = simulation->effort().blocksCut;
        apply(*simulation, program);
        simulation->seek(program->blockCount());
        EXPECT_LE(100 * (simulation->effort().blocksCut - before), 15 * program->blockCount());

        const auto fresh = startedSimulation(program, setup, parameters);
        fresh->play(program->blockCount());
        simulation->play(program->blockCount());
        ASSERT_GE(fresh->effort().blocksCut, program->blockCount());
        const Frame frame = simulation->frame();
        const Frame expected = fresh->frame();
        EXPECT_TRUE(sameZMap(simulation->zmap(), fresh->zmap()));
        EXPECT_EQ(frame.removedMm3, expected.removedMm3);
        EXPECT_EQ(sentences(frame.findings), sentences(expected.findings));
        ASSERT_EQ(frame.statistics.size(), expected.statistics.size());
        for (std::size_t row = 0; row < frame.statistics.size(); ++row)
            ASSERT_EQ(outcome(frame.statistics[row]), outcome(expected.statistics[row])) << "row " << row;
    }
}

TEST(Edit, BehindThePositionKeepsThePosition) {
    const auto simulation =
        startedSimulation(programOf("T1 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30\nY20\n"), smallSetup(), {});
    simulation->seek(2);
    apply(*simulation, programOf("T1 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30\nY10\nX5\n"));
    EXPECT_EQ(simulation->position(), 2U);
    EXPECT_EQ(simulation->blockCount(), 5U);
}

TEST(Edit, ThatSelectsAToolRestarts) {
    const auto setup = smallSetup();
    const auto simulation = startedSimulation(programOf("G0 X5 Y5 Z5\nG1 Z-2 F100\nX30\n"), setup, {});
    simulation->seek(3);
    EXPECT_GT(simulation->frame().removedMm3, 0);
    // The first blocks have the same text, but a tool is no longer assumed for them.
    const auto program = programOf("G0 X5 Y5 Z5\nG1 Z-2 F100\nX30\nT2 M6\nG1 Y20\n");
    apply(*simulation, program);
    simulation->seek(3);
    EXPECT_EQ(simulation->frame().removedMm3, 0);
}

TEST(Edit, OnlyNotedGoesBackToAValidBlockOfTheNewProgram) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const std::string text = randomProgram(seed, 120);
    std::string edited = text;
    edited.insert(edited.find("M30"), "G1 X3 Y3 Z-4 F100\n");
    for (const int line : {60, 90}) {
        std::size_t at = 0;
        for (int k = 0; k < line; ++k)
            at = edited.find('\n', at) + 1;
        edited.insert(at, "G1 X20 Y20 Z-5 F100\n");
        const auto simulation = startedSimulation(programOf(text), smallSetup(), {});
        RimFinder rims;
        simulation->seek(110);
        simulation->refine(rims); // the refined surface at rest must not survive the edit
        const auto program = programOf(edited);
        const std::size_t wanted = simulation->noteProgram(program);
        EXPECT_LE(simulation->position(), wanted);
        EXPECT_EQ(simulation->frame().level, ErrorLevel::sample);
        const auto straight = straightRun(program, smallSetup(), {});
        EXPECT_TRUE(sameZMap(simulation->zmap(), straight[simulation->position()].zmap));
        simulation->seek(wanted);
        EXPECT_EQ(difference(simulation->frame(), straight[wanted]), "");
        simulation->seek(program->blockCount());
        EXPECT_EQ(difference(simulation->frame(), straight.back()), "");
    }
}

} // namespace
} // namespace proveout
