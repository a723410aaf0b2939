// SPDX-License-Identifier: GPL-3.0-or-later
// A seek over blocks that were never executed cuts many at once. Whatever the portions, the heights, records
// and findings must be those of one block after the other, to the last bit, wherever the seek is stopped.
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <random>
#include <sstream>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/cutter/cutter.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/run/removed_volume.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr const char* kTools[]{
    "ball:d=4,l=20",       "flat:d=3,l=2",        "bull:d=6,r=1,l=10",    "cone:d=6,angle=90,l=5",
    "drill:d=5,angle=118", "lollipop:d=4,neck=2", "tslot:d=8,w=2,neck=3", "dovetail:d=6,angle=60,h=2",
};

/// The random program with what makes blocks special: tool changes, tools that the table lacks, rapids into
/// and over the stock from known and from unknown positions, and drilling cycles of many pecks.
std::string eventfulProgram(std::uint_fast32_t seed, int blocks) {
    std::mt19937 random(seed);
    std::istringstream in(randomProgram(seed, blocks));
    std::string text;
    for (std::string line; std::getline(in, line);) {
        text += line + "\n";
        switch (line == "M30" ? 99 : random() % 40) {
        case 0:
            text += "T" + std::to_string(1 + random() % 10) + " M6\n";
            break;
        case 1:
            text += "G28\n";
            break;
        case 2:
            text += "G0 X" + std::to_string(random() % 40) + " Z-" + std::to_string(random() % 5) + "\n";
            break;
        case 3:
            text += "G83 X20 Y" + std::to_string(random() % 30) + " Z-8 R2 Q0." +
                    std::to_string(1 + random() % 8) + " F300\nG80\n";
            break;
        case 4:
            text += "G53 G0 Z0\n";
            break;
        default:
            break;
        }
    }
    return text;
}

std::shared_ptr<const Setup> setupOf(std::mt19937& random) {
    auto setup = std::make_shared<Setup>(*smallSetup(0.4));
    int number = 1;
    for (const char* spec : kTools)
        setup->tools.set(number++, parseCutter(spec).value());
    if (random() % 2 == 0)
        setup->start = Vec3(5, 5, 20);
    return setup;
}

bool sameRecord(const CutRecord& a, const CutRecord& b) {
    return a.removedMm3 == b.removedMm3 && a.maxDepth == b.maxDepth && a.points == b.points &&
           a.changed == b.changed && a.engagedFrom == b.engagedFrom && a.engagedTo == b.engagedTo;
}

TEST(Portions, HaveTheHeightsRecordsAndFindingsOfSingleBlocks) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < roundsOf(40); ++round) {
        const auto program = programOf(eventfulProgram(random(), 150));
        const auto setup = setupOf(random);
        const ToolChoice tools(*program, *setup);
        ZMap alone = uncutStock(setup->stock, setup->shape, *makeGrid(setup->stock, setup->spacing)).zmap;
        ZMap together(alone.snapshot());
        FindingLog aloneLog;
        FindingLog togetherLog;
        PortionCutting cutting;
        for (std::size_t first = 0; first < program->blockCount();) {
            const std::size_t last = std::min(first + 1 + random() % 60, program->blockCount());
            const auto records =
                cutBlocksInTurn(together, *program, first, last, *setup, tools, &togetherLog, {}, cutting);
            ASSERT_TRUE(records);
            ASSERT_EQ(records->size(), last - first);
            for (; first < last; ++first) {
                const auto record = cutBlock(alone, *program, first, *setup, tools, &aloneLog, {});
                ASSERT_TRUE(sameRecord(*record, (*records)[records->size() - (last - first)]))
                    << "round " << round << " block " << first;
            }
            ASSERT_TRUE(sameZMap(alone.snapshot(), together.snapshot())) << "round " << round;
        }
        ASSERT_EQ(aloneLog.diagnostics(*program, tools), togetherLog.diagnostics(*program, tools));
    }
}

TEST(Portions, FindWithoutRecordsWhatSingleBlocksFind) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < roundsOf(40); ++round) {
        const auto program = programOf(eventfulProgram(random(), 150));
        const auto setup = setupOf(random);
        DecimationParameters parameters;
        parameters.method = DecimationMethod::none;
        const auto wanted = straightRun(program, setup, parameters).back();
        const auto simulation = startedSimulation(program, setup, parameters);
        simulation->setCheckpointBudget(0);
        simulation->keepRecordsOf({});
        if (random() % 2 == 0)
            simulation->seek(random() % program->blockCount());
        simulation->seek(program->blockCount());
        const Frame frame = simulation->frame();
        ASSERT_TRUE(sameZMap(frame.zmap, wanted.zmap)) << "round " << round;
        ASSERT_EQ(frame.findings, wanted.findings) << "round " << round;
        ASSERT_NEAR(frame.removedMm3, wanted.removedMm3, 1e-9 * (1 + wanted.removedMm3)) << "round " << round;
        ASSERT_EQ(frame.statistics.size(), wanted.statistics.size());
        ASSERT_FALSE(frame.statistics[frame.block / 2].isRecorded());
    }
}

TEST(RemovedVolume, CountsTheLeastStepOfASinglePointAndNothingElse) {
    ZMap zmap({{0, 0, 0}, 100, 80, 40}, makeGrid({{0, 0, 0}, 100, 80, 40}, 0.5).value());
    const RemovedVolume removed(zmap);
    EXPECT_EQ(removed.removedFrom(zmap), 0);
    float& height = zmap.tileForWriting(1).heights[Tile::kSize + 3]; // inside: i = 67, j = 1
    height = std::nextafter(-30.0F, -40.0F);
    const RemovedVolume later(zmap);
    const double before = -double{height};
    EXPECT_DOUBLE_EQ(removed.removedFrom(zmap), before * 0.25);
    height = std::nextafter(height, -40.0F);
    EXPECT_DOUBLE_EQ(later.removedFrom(zmap), (-double{height} - before) * 0.25);
    zmap.tileForWriting(0).heights[0] = -8; // a corner of the map: a quarter of a cell
    zmap.tileForWriting(0).heights[5] = -8; // its border: half of one
    EXPECT_NEAR(later.removedFrom(zmap), 8 * 0.25 * 0.75, 1e-5);
}

/// The columns that a seek knows as well.
std::string withoutTimes(const Frame& frame) {
    std::ostringstream text;
    text.precision(17);
    for (std::size_t k = 0; k < frame.block; ++k) {
        const BlockStatistics& row = frame.statistics[k];
        text << row.facesFull << ' ' << row.removedMm3 << ' ' << row.maxDepth << ' ' << row.radialEngagement
             << '\n';
    }
    return text.str();
}

struct Budget {
    const char* name;
    std::size_t bytes;
};
class Seek : public testing::TestWithParam<Budget> {};

TEST_P(Seek, OverNewBlocksEndsAsAStraightRunDoesWhereverItIsStopped) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    int kept = 0;
    for (int round = 0; round < roundsOf(20); ++round) {
        const auto program = programOf(eventfulProgram(random(), 120));
        const auto setup = setupOf(random);
        DecimationParameters parameters;
        parameters.method = random() % 3 == 0 ? DecimationMethod::none : DecimationMethod::certified;
        parameters.regionCells = 8;
        parameters.period = static_cast<int>(random() % 40) - 1;
        const auto straight = straightRun(program, setup, parameters);
        const auto simulation = startedSimulation(program, setup, parameters);
        simulation->setCheckpointBudget(GetParam().bytes);
        while (!simulation->atEnd() || !simulation->settled()) {
            const std::size_t before = simulation->rows().size();
            const std::size_t goal = random() % (program->blockCount() + 1);
            std::stop_source source;
            WorkContext context;
            context.stop = source.get_token();
            const double limit = std::uniform_real_distribution<double>(0, 1.5)(random);
            context.progress = [&](double done) {
                if (done > limit)
                    source.request_stop();
            };
            simulation->seek(random() % 4 == 0 ? program->blockCount() : goal, context);
            kept += source.stop_requested() && simulation->rows().size() > before ? 1 : 0;
            const Frame frame = simulation->frame();
            ASSERT_TRUE(sameZMap(frame.zmap, straight[frame.block].zmap)) << "round " << round;
            ASSERT_EQ(withoutTimes(frame), withoutTimes(straight[frame.block]));
            ASSERT_EQ(frame.removedMm3, straight[frame.block].removedMm3);
            if (simulation->settled()) {
                ASSERT_EQ(difference(frame, straight[frame.block]), "")
                    << "round " << round << " at " << frame.block;
            }
        }
        ASSERT_EQ(simulation->frame().findings, straight.back().findings);
    }
    if (roundsOf(20) >= 10) {
        EXPECT_GT(kept, 0) << "no stop kept new blocks";
    }
}

INSTANTIATE_TEST_SUITE_P(Budgets, Seek, testing::Values(Budget{"Plenty", 1'000'000'000}, Budget{"None", 0}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Play, MeasuresWhatASeekHasPassed) {
    const auto program = programOf(randomProgram(7, 60));
    DecimationParameters parameters;
    parameters.regionCells = 8;
    parameters.period = 10;
    const auto setup = smallSetup();
    const auto simulation = startedSimulation(program, setup, parameters);
    simulation->step();
    simulation->seek(40);
    EXPECT_TRUE(simulation->rows()[0].isPlayed());
    EXPECT_FALSE(simulation->rows()[20].isPlayed());
    EXPECT_FALSE(simulation->rows()[20].surfaceIsMeasured());
    EXPECT_FALSE(simulation->rows()[39].isPlayed());
    EXPECT_TRUE(simulation->rows()[39].surfaceIsMeasured());
    simulation->play(program->blockCount());
    const auto straight = straightRun(program, setup, parameters);
    for (std::size_t k = 0; k < program->blockCount(); ++k) {
        const BlockStatistics& row = simulation->rows()[k];
        const BlockStatistics& wanted = straight.back().statistics[k];
        EXPECT_TRUE(row.isPlayed()) << k;
        EXPECT_EQ(row.facesShown, wanted.facesShown) << k;
        EXPECT_EQ(row.regionsDirty, wanted.regionsDirty) << k;
        EXPECT_EQ(row.regionsDecimated, wanted.regionsDecimated) << k;
    }
    EXPECT_EQ(difference(simulation->frame(), straight.back()), "");
}

/// The surface of many moments is made at once, while the blocks after them are cut.
TEST(Play, HasTheRowsAndTheSurfaceOfStepsWhereverItIsStopped) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < roundsOf(8); ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        const auto program = programOf(eventfulProgram(random(), 300));
        const auto setup = smallSetup(0.2);
        DecimationParameters parameters;
        parameters.method =
            std::array{DecimationMethod::certified, DecimationMethod::certified, DecimationMethod::lee,
                       DecimationMethod::none}[static_cast<std::size_t>(round % 4)];
        parameters.regionCells = 4 << random() % 4;
        parameters.period = std::array{1, 2, 5, 60, -1}[random() % 5];
        parameters.borders = random() % 4 == 0 ? BorderRule::paper : BorderRule::shared;
        const auto straight = straightRun(program, setup, parameters);
        const auto simulation = startedSimulation(program, setup, parameters);
        for (int turn = 0; turn < 4; ++turn) {
            if (random() % 3 == 0)
                simulation->seek(random() % (program->blockCount() + 1));
            std::stop_source source;
            const auto wait = std::chrono::microseconds(random() % 60'000);
            const std::jthread stopper([&] {
                std::this_thread::sleep_for(wait);
                source.request_stop();
            });
            double reported = 0;
            const std::size_t goal = random() % (program->blockCount() + 1);
            simulation->play(goal, {source.get_token(), [&](double done) {
                                        EXPECT_GE(done, reported);
                                        reported = done;
                                    }});
            const Frame frame = simulation->frame();
            ASSERT_TRUE(sameZMap(frame.zmap, straight[frame.block].zmap));
            for (std::size_t k = 0; k < frame.statistics.size(); ++k) {
                if (frame.statistics[k].isPlayed()) {
                    ASSERT_EQ(outcome(frame.statistics[k]), outcome(straight.back().statistics[k])) << k;
                }
                ASSERT_EQ(frame.statistics[k].removedMm3, straight.back().statistics[k].removedMm3) << k;
            }
            simulation->seek(simulation->position());
            ASSERT_EQ(difference(simulation->frame(), straight[frame.block]), "") << "at " << frame.block;
        }
        simulation->play(program->blockCount());
        const Frame frame = simulation->frame();
        ASSERT_EQ(difference(frame, straight.back()), "");
        ASSERT_EQ(frame.findings, straight.back().findings);
        ASSERT_EQ(frame.removedMm3, straight.back().removedMm3);
        for (std::size_t k = 0; k < program->blockCount(); ++k) {
            ASSERT_TRUE(frame.statistics[k].isPlayed()) << k;
            ASSERT_EQ(outcome(frame.statistics[k]), outcome(straight.back().statistics[k])) << k;
        }
    }
}

} // namespace
} // namespace proveout
