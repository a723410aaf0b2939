// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <random>
#include <thread>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

struct SeekCase {
    const char* name;
    DecimationParameters parameters;
    std::size_t checkpointBudget;
};

DecimationParameters withPeriod(int period, DecimationMethod method = DecimationMethod::lee) {
    DecimationParameters parameters;
    parameters.period = period;
    parameters.method = method;
    return parameters;
}

const SeekCase kCases[] = {
    {"period 20", withPeriod(20), 1'000'000'000},
    {"period 1", withPeriod(1), 1'000'000'000},
    {"period 7, hardly any checkpoint", withPeriod(7), 200'000},
    {"once at the start", withPeriod(-1), 1'000'000'000},
    {"never", withPeriod(0), 1'000'000'000},
    {"global", withPeriod(20, DecimationMethod::global), 1'000'000'000},
    {"no decimation", withPeriod(20, DecimationMethod::none), 1'000'000'000},
};

TEST(Simulation, RunTwiceIsEqual) {
    const auto program = programOf(randomProgram(11, 120));
    const auto first = straightRun(program, smallSetup(), withPeriod(20));
    const auto second = straightRun(program, smallSetup(), withPeriod(20));
    ASSERT_EQ(first.size(), program->blockCount() + 1);
    for (std::size_t block = 0; block < first.size(); ++block)
        ASSERT_EQ(difference(first[block], second[block]), "") << "block " << block;
}

TEST(Simulation, RandomSeeksEqualAStraightRun) {
    const int seeks = roundsOf(250); // for each case, so more than 1 000 in total
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (const SeekCase& row : kCases) {
        SCOPED_TRACE(row.name);
        const auto program = programOf(randomProgram(random(), 160));
        const auto setup = smallSetup();
        const auto straight = straightRun(program, setup, row.parameters);
        const auto simulation = startedSimulation(program, setup, row.parameters);
        simulation->setCheckpointBudget(row.checkpointBudget);
        std::uniform_int_distribution<std::size_t> anyBlock(0, program->blockCount());
        for (int seek = 0; seek < seeks; ++seek) {
            const std::size_t block = anyBlock(random);
            simulation->seek(block);
            ASSERT_EQ(difference(simulation->frame(), straight[block]), "")
                << "seek " << seek << " to " << block;
            for (std::size_t step = random() % 4; step > 0 && !simulation->atEnd(); --step) {
                simulation->step();
                ASSERT_EQ(difference(simulation->frame(), straight[simulation->position()]), "")
                    << "step after seek " << seek;
            }
        }
    }
}

TEST(Simulation, StepsBackwardEqualAStraightRun) {
    const auto program = programOf(randomProgram(5, 90));
    const auto straight = straightRun(program, smallSetup(), withPeriod(20));
    const auto simulation = startedSimulation(program, smallSetup(), withPeriod(20));
    simulation->seek(program->blockCount());
    for (std::size_t block = program->blockCount(); block-- > 0;) {
        simulation->seek(block);
        ASSERT_EQ(difference(simulation->frame(), straight[block]), "") << "block " << block;
    }
}

TEST(Simulation, SeeksAreClamped) {
    const auto program = programOf(randomProgram(5, 20));
    const auto simulation = startedSimulation(program, smallSetup(), withPeriod(20));
    simulation->seek(1'000'000);
    EXPECT_EQ(simulation->position(), program->blockCount());
    EXPECT_TRUE(simulation->atEnd());
    simulation->step();
    EXPECT_EQ(simulation->position(), program->blockCount());
}

TEST(Simulation, SeeksShareTheTilesThatDidNotChange) {
    const auto program = programOf("T1 M6\nG0 X5 Y5 Z5\nG1 Z-3 F100\nG0 Z5\nX6\n");
    const auto simulation = startedSimulation(program, smallSetup(0.1), withPeriod(20));
    simulation->seek(2);
    const ZMapSnapshot before = simulation->zmap();
    simulation->seek(4);
    const ZMapSnapshot after = simulation->zmap();
    for (std::size_t tile = 0; tile < before.tileCount(); ++tile)
        EXPECT_EQ(before.tile(tile), after.tile(tile)) << "tile " << tile;
}

TEST(Seek, ReportsItsProgressRisingOnItsOwnThread) {
    const auto program = programOf(randomProgram(17, 300));
    const auto simulation = startedSimulation(program, smallSetup(), {});
    for (const std::size_t block : {300U, 250U, 37U, 300U, 0U}) {
        double last = 0;
        std::size_t reported = 0;
        const auto self = std::this_thread::get_id();
        simulation->seek(block, {{}, [&](double done) {
                                     EXPECT_GE(done, last) << "towards block " << block;
                                     EXPECT_LE(done, 1);
                                     EXPECT_EQ(std::this_thread::get_id(), self);
                                     last = done;
                                     ++reported;
                                 }});
        EXPECT_GT(reported, 0U) << "towards block " << block;
    }
}

} // namespace
} // namespace proveout
