// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <random>

#include "core/decimation/surface/refined_surface.h"
#include "core/simulation/run/rim_finder.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

DecimationParameters smallRegions() {
    DecimationParameters parameters;
    parameters.regionCells = 6;
    return parameters;
}

/// The surface that must be shown at rest, computed only from the z-map of a frame.
std::vector<LatticeTriangle> fromScratch(const Frame& frame) {
    const Grid& grid = frame.zmap.grid();
    RefinedSurface surface(grid.nx, grid.ny, frame.parameters);
    EXPECT_TRUE(surface.follow(frame.zmap, {}));
    return surface.snapshot().triangles();
}

TEST(AtRest, ShowsTheSameHoweverOneGotThere) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    auto program = programOf(randomProgram(random(), 80));
    const auto simulation = startedSimulation(program, smallSetup(), smallRegions());
    RimFinder rims;
    for (int round = 0; round < 60; ++round) {
        switch (random() % 5) {
        case 0:
            simulation->step();
            break;
        case 1: {
            DecimationParameters other = smallRegions();
            other.allowance = random() % 2 == 0 ? 0.02 : 0.1;
            other.level = random() % 3 == 0 ? ErrorLevel::sample : ErrorLevel::surface;
            apply(*simulation, other);
            break;
        }
        case 2:
            program = programOf(randomProgram(random(), 80));
            apply(*simulation, program);
            break;
        default:
            simulation->seek(random() % (simulation->blockCount() + 1));
        }
        ASSERT_TRUE(simulation->canRefine() ||
                    simulation->frame().surface.triangles() == fromScratch(simulation->frame()));
        if (random() % 3 == 0) { // stopped: the surface of the schedule is still shown
            std::stop_source source;
            source.request_stop();
            simulation->refine(rims, {source.get_token(), {}});
        }
        simulation->refine(rims);
        EXPECT_FALSE(simulation->canRefine());
        const Frame frame = simulation->frame();
        EXPECT_EQ(frame.level, frame.parameters.level);
        EXPECT_EQ(frame.surface.dirtyRegions, 0U);
        ASSERT_EQ(frame.surface.triangles(), fromScratch(frame)) << "round " << round;
    }
}

TEST(AtRest, DoesNotTouchTheSurfaceOfTheSchedule) {
    const auto program = programOf(randomProgram(7, 60));
    const auto straight = straightRun(program, smallSetup(), smallRegions());
    const auto simulation = startedSimulation(program, smallSetup(), smallRegions());
    RimFinder rims;
    for (std::size_t block = 1; block <= 60; ++block) {
        simulation->refine(rims);
        EXPECT_EQ(simulation->frame().level, smallRegions().level);
        simulation->step();
        ASSERT_EQ(difference(simulation->frame(), straight[block]), "") << "block " << block;
        EXPECT_EQ(simulation->frame().level, ErrorLevel::sample);
    }
}

TEST(AtRest, OnlyACertifiedScheduleIsRefined) {
    const auto program = programOf(randomProgram(8, 30));
    DecimationParameters lee = smallRegions();
    lee.method = DecimationMethod::lee;
    DecimationParameters never = smallRegions();
    never.period = 0;
    DecimationParameters once = smallRegions();
    once.period = -1;
    DecimationParameters exact = smallRegions();
    exact.allowance = 0;
    for (const DecimationParameters& parameters : {lee, never, once, exact}) {
        const auto simulation = startedSimulation(program, smallSetup(), parameters);
        RimFinder rims;
        simulation->seek(20);
        const Frame before = simulation->frame();
        EXPECT_FALSE(simulation->canRefine());
        simulation->refine(rims);
        EXPECT_EQ(difference(simulation->frame(), before), "");
    }
}

} // namespace
} // namespace proveout
