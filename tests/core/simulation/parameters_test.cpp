// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <random>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

DecimationParameters randomParameters(std::mt19937& random) {
    static constexpr int kPeriods[] = {-1, 0, 1, 3, 20, 1000};
    static constexpr int kRegions[] = {2, 5, 8, 13, 64};
    static constexpr double kAllowances[] = {0, 0.01, 0.05, 0.3};
    DecimationParameters parameters;
    parameters.period = kPeriods[random() % std::size(kPeriods)];
    parameters.regionCells = kRegions[random() % std::size(kRegions)];
    parameters.allowance = kAllowances[random() % std::size(kAllowances)];
    parameters.method = static_cast<DecimationMethod>(random() % 3);
    parameters.certify = random() % 2 == 0;
    parameters.borders = static_cast<BorderRule>(random() % 2);
    parameters.seed = static_cast<int>(random() % 5);
    return parameters;
}

TEST(Parameters, ChangedAtABlockEqualAFreshRunThere) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto program = programOf(randomProgram(random(), 70));
    const auto setup = smallSetup();
    const auto simulation = startedSimulation(program, setup, {});
    for (int change = 0; change < 40; ++change) {
        const auto parameters = randomParameters(random);
        SCOPED_TRACE(testing::Message() << "change " << change << ", period " << parameters.period);
        simulation->seek(random() % (program->blockCount() + 1));
        const std::size_t block = simulation->position();
        apply(*simulation, parameters);
        const auto fresh = startedSimulation(program, setup, parameters);
        while (fresh->position() < block)
            fresh->step();
        ASSERT_EQ(simulation->position(), block);
        ASSERT_EQ(difference(simulation->frame(), fresh->frame()), "") << "at block " << block;
        for (int step = 0; step < 3 && !fresh->atEnd(); ++step) {
            fresh->step();
            simulation->step();
            ASSERT_EQ(difference(simulation->frame(), fresh->frame()), "") << "behind block " << block;
        }
    }
}

TEST(Parameters, OutOfRangeAreRefusedAtTheStartAndIgnoredLater) {
    DecimationParameters wrong;
    wrong.regionCells = 0;
    const auto program = programOf(randomProgram(1, 10));
    const auto refused = Simulation::create(program, smallSetup(), wrong);
    ASSERT_FALSE(refused);
    EXPECT_STREQ(refused.error().front().id, "parameter-out-of-range");
    const auto simulation = startedSimulation(program, smallSetup(), {});
    wrong = {};
    wrong.allowance = std::numeric_limits<double>::quiet_NaN();
    apply(*simulation, wrong);
    EXPECT_EQ(simulation->frame().parameters, DecimationParameters{});
}

TEST(Parameters, AreKeptAndStatisticsStay) {
    const auto program = programOf(randomProgram(2, 45));
    const auto simulation = startedSimulation(program, smallSetup(), {});
    simulation->seek(45);
    const auto before = simulation->frame();
    DecimationParameters coarse;
    coarse.allowance = 0.5;
    apply(*simulation, coarse);
    const auto after = simulation->frame();
    EXPECT_EQ(after.parameters, coarse);
    ASSERT_EQ(after.statistics.size(), before.statistics.size());
    for (std::size_t row = 0; row + 1 < before.statistics.size(); ++row)
        EXPECT_EQ(after.statistics[row].facesShown, before.statistics[row].facesShown);
    EXPECT_EQ(after.statistics[44].facesShown, after.surface.faces);
    EXPECT_LT(after.surface.faces, before.surface.faces);
}

TEST(Parameters, OnlyNotedLeaveTheWorkToTheNextSeek) {
    const auto simulation = startedSimulation(programOf(randomProgram(2, 45)), smallSetup(), {});
    simulation->seek(45);
    const double seconds = simulation->effort().decimationSeconds;
    DecimationParameters coarse;
    coarse.allowance = 0.5;
    simulation->noteParameters(coarse);
    EXPECT_FALSE(simulation->settled());
    EXPECT_EQ(simulation->effort().decimationSeconds, seconds);
    simulation->noteParameters(coarse);
    EXPECT_FALSE(simulation->settled()) << "the same once more is no reason to forget the work";
    simulation->seek(45);
    EXPECT_TRUE(simulation->settled());
    coarse.period = 0; // nothing to decimate, so no work remains
    simulation->noteParameters(coarse);
    EXPECT_TRUE(simulation->settled());
}

TEST(DecimatedNow, DecimatesEverythingAndChangesNothing) {
    DecimationParameters never;
    never.period = 0;
    never.method = DecimationMethod::lee; // a method whose meshes are those of the schedule
    never.regionCells = 8;
    const auto program = programOf(randomProgram(2, 45));
    const auto simulation = startedSimulation(program, smallSetup(), never);
    simulation->seek(33);
    const Frame before = simulation->frame();
    const SurfaceSnapshot all = simulation->decimatedNow();
    EXPECT_EQ(all.dirtyRegions, 0U);
    EXPECT_LT(all.faces, all.facesFull);
    EXPECT_EQ(difference(simulation->frame(), before), "");
    EXPECT_EQ(before.surface.faces, before.surface.facesFull);
    // The schedule's own meshes at the same moment are identical.
    DecimationParameters every = never;
    every.period = 33;
    const auto scheduled = startedSimulation(program, smallSetup(), every);
    scheduled->seek(33);
    EXPECT_EQ(scheduled->frame().surface.triangles(), all.triangles());
}

} // namespace
} // namespace proveout
