// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/records/activity_log.h"

#include <gtest/gtest.h>
#include <random>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

/// Rows of which about every third cuts.
PersistentArray<BlockStatistics> randomRows(std::mt19937& random, std::size_t count) {
    PersistentArray<BlockStatistics> rows;
    for (std::size_t block = 0; block < count; ++block) {
        BlockStatistics row;
        row.maxDepth = random() % 3 == 0 ? 1.0F : 0.0F;
        rows.push_back(row);
    }
    return rows;
}

/// Sums block by block.
ActivitySums addedUp(const Program& program, const PersistentArray<BlockStatistics>& rows,
                     const MachineTimes* times, std::size_t first, std::size_t last) {
    ActivitySums sums;
    for (std::size_t block = first; block < last; ++block) {
        const auto index = static_cast<std::size_t>(activityOf(program, block, rows[block]));
        ++sums.blocks.at(index);
        sums.seconds.at(index) += times != nullptr ? times->movingSeconds(block) : 0;
    }
    return sums;
}

void expectSame(const ActivitySums& sums, const ActivitySums& expected) {
    EXPECT_EQ(sums.blocks, expected.blocks);
    for (std::size_t index = 0; index < kActivities; ++index) {
        EXPECT_NEAR(sums.seconds.at(index), expected.seconds.at(index), 1e-9);
        EXPECT_NEAR(sums.share(static_cast<Activity>(index)), expected.share(static_cast<Activity>(index)),
                    1e-6);
    }
}

TEST(ActivityLog, ReportsRapidsAirAndCutting) {
    const auto program = programOf("G21 G90\nT1 M6\nG0 X-10 Y15 Z-2\nG1 X-5 F600\nX20\nG0 X25\nZ5\nG1 X30\n");
    const auto simulation = startedSimulation(program, smallSetup(), {});
    simulation->seek(program->blockCount());
    const Frame frame = simulation->frame();
    ActivityLog log;
    log.append(*program, frame.statistics, frame.block);
    const std::vector<Activity> expected{Activity::rapid,        Activity::air,   Activity::cutting,
                                         Activity::rapidInStock, Activity::rapid, Activity::air};
    ASSERT_EQ(log.size(), expected.size());
    for (std::size_t block = 0; block < expected.size(); ++block)
        EXPECT_EQ(log.sums(block, block + 1).share(expected[block]), 1) << block;
}

TEST(ActivityLog, SumsOfAnyStretchAreThoseOfItsBlocks) {
    const unsigned seed = randomSeed();
    RecordProperty("seed", std::to_string(seed));
    SCOPED_TRACE("PROVEOUT_SEED=" + std::to_string(seed));
    std::mt19937 random(seed);
    for (int round = 0; round < 20; ++round) {
        const auto program = programOf(randomProgram(random(), 1 + static_cast<int>(random() % 500)));
        const std::size_t count = program->blockCount();
        const auto rows = randomRows(random, count);
        const auto times = round % 4 == 0 ? nullptr : machineTimes(program, {});
        ActivityLog log;
        if (round % 2 == 0)
            log.setTimes(times);
        while (log.size() < count)
            log.append(*program, rows, log.size() + 1 + random() % 100);
        log.setTimes(times);
        expectSame(log.total(), addedUp(*program, rows, times.get(), 0, count));
        for (int stretch = 0; stretch < 50; ++stretch) {
            const std::size_t first = random() % (count + 1);
            const std::size_t last = first + random() % (count + 1 - first);
            expectSame(log.sums(first, last), addedUp(*program, rows, times.get(), first, last));
        }
        EXPECT_TRUE(log.sums(count, count + 10).empty());
    }
}

TEST(ActivityLog, KnowsOnlyWhatWasExecuted) {
    const auto program = programOf(randomProgram(1, 200));
    std::mt19937 random(1);
    const auto rows = randomRows(random, 120);
    ActivityLog log;
    log.append(*program, rows, 1000);
    EXPECT_EQ(log.size(), 120U);
    EXPECT_TRUE(log.sums(120, 200).empty());
    expectSame(log.sums(100, 200), addedUp(*program, rows, nullptr, 100, 120));
    log.clear();
    EXPECT_TRUE(log.total().empty());
    EXPECT_TRUE(log.sums(0, 200).empty());
}

TEST(ActivityLog, BlocksThatTakeNoTimeAreSharedByTheirCount) {
    const auto program = programOf("G21 G90\nG0 X0 Y0 Z5\nG1 X10 F600\nX10\nX10\nX10\nX10\nX20\n");
    PersistentArray<BlockStatistics> rows(program->blockCount());
    rows.edit(2).maxDepth = 1;
    ActivityLog log;
    log.append(*program, rows, program->blockCount());
    log.setTimes(machineTimes(program, {}));
    const ActivitySums still = log.sums(2, 6);
    EXPECT_EQ(still.seconds, (std::array<double, kActivities>{}));
    EXPECT_EQ(still.share(Activity::cutting), 0.25);
    EXPECT_EQ(still.share(Activity::air), 0.75);
}

} // namespace
} // namespace proveout
