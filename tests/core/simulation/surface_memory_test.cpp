// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that needs more memory than is allowed is given up; the stock is cut and shown nevertheless.
#include <algorithm>
#include <gtest/gtest.h>
#include <string_view>
#include <vector>

#include "core/simulation/setup/setup_memory.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

/// 121 × 161 points and 4800 regions: the memory is looked at when they are decimated for the first time.
std::shared_ptr<const Setup> manyRegions() {
    return smallSetup(0.25);
}

DecimationParameters smallestRegions() {
    DecimationParameters parameters;
    parameters.regionCells = 2;
    return parameters;
}

/// From now on the process takes more than what it may.
[[nodiscard]] std::vector<char> useUp(Simulation& simulation) {
    constexpr std::size_t kBytes = 16'000'000;
    simulation.allowMemory(0);
    return std::vector<char>(kBytes, 1);
}

bool hasFinding(const Frame& frame) {
    return std::ranges::any_of(frame.findings, [](const Diagnostic& finding) {
        return std::string_view(finding.id) == "surface-too-large";
    });
}

TEST(SurfaceMemory, GivesUpASurfaceThatIsTooLargeAndCutsOn) {
    const auto program = programOf(randomProgram(1, 60));
    const auto allowed = startedSimulation(program, manyRegions(), smallestRegions());
    auto limited = Simulation::prepare(program, manyRegions(), smallestRegions()).value();
    const auto more = useUp(*limited);
    for (const std::size_t block : {0, 1, 23, 60, 11, 12}) {
        if (limited->position() + 1 == block)
            limited->step();
        else
            limited->seek(block);
        allowed->seek(block);
        const Frame frame = limited->frame();
        EXPECT_TRUE(limited->settled());
        EXPECT_FALSE(limited->canRefine());
        EXPECT_TRUE(hasFinding(frame));
        EXPECT_EQ(frame.block, block);
        EXPECT_EQ(frame.surface.dirtyRegions, frame.surface.grid.regionCount());
        EXPECT_EQ(frame.surface.faces, frame.surface.facesFull);
        EXPECT_TRUE(sameZMap(frame.zmap, allowed->frame().zmap));
    }
    EXPECT_FALSE(hasFinding(allowed->frame()));
}

TEST(SurfaceMemory, IsDecimatedAgainWithOtherParameters) {
    const auto program = programOf(randomProgram(2, 60));
    auto simulation = Simulation::prepare(program, manyRegions(), smallestRegions()).value();
    const auto more = useUp(*simulation);
    simulation->seek(40);
    ASSERT_TRUE(hasFinding(simulation->frame()));
    simulation->allowMemory(UINT64_MAX / 2);
    DecimationParameters larger = smallestRegions();
    larger.allowance = 0.1;
    apply(*simulation, larger);
    EXPECT_FALSE(hasFinding(simulation->frame()));
    const auto fresh = startedSimulation(program, manyRegions(), larger);
    fresh->seek(40);
    EXPECT_EQ(difference(simulation->frame(), fresh->frame()), "");
}

TEST(SurfaceMemory, IsGivenUpWhileAProgramIsPlayed) {
    const auto program = programOf(randomProgram(5, 60));
    const auto played = startedSimulation(program, manyRegions(), smallestRegions());
    const auto more = useUp(*played); // the uncut stock was decimated before
    played->play(60);
    EXPECT_TRUE(played->settled());
    EXPECT_TRUE(hasFinding(played->frame()));
    const auto fresh = startedSimulation(program, manyRegions(), smallestRegions());
    fresh->seek(60);
    EXPECT_EQ(played->position(), 60U);
    EXPECT_TRUE(sameZMap(played->frame().zmap, fresh->frame().zmap));
    EXPECT_EQ(played->frame().findings.size(), fresh->frame().findings.size() + 1);
    for (std::size_t block = 0; block < 60; ++block)
        EXPECT_EQ(played->rows()[block].removedMm3, fresh->rows()[block].removedMm3) << block;
}

TEST(SurfaceMemory, OfAnEditedProgramStaysGivenUp) {
    auto simulation =
        Simulation::prepare(programOf(randomProgram(3, 60)), manyRegions(), smallestRegions()).value();
    const auto more = useUp(*simulation);
    simulation->seek(40);
    const auto edited = programOf(randomProgram(4, 60));
    apply(*simulation, edited);
    simulation->seek(60);
    EXPECT_TRUE(simulation->settled());
    EXPECT_TRUE(hasFinding(simulation->frame()));
    const auto fresh = startedSimulation(edited, manyRegions(), smallestRegions());
    fresh->seek(60);
    EXPECT_TRUE(sameZMap(simulation->frame().zmap, fresh->frame().zmap));
}

TEST(SetupMemory, RequiresOnlyTheMapsAndNamesTheExpectedAndTheMost) {
    proveout::Setup setup = *smallSetup(0.01);
    const Grid grid = makeGrid(setup.stock, setup.spacing).value();
    const MemoryForecast forecast = memoryForecast(setup, grid, {});
    EXPECT_GT(forecast.expected, 2 * zmapBytes(grid)) << "the map, and that of the last moment";
    EXPECT_LT(forecast.expected, 0.7 * forecast.most);
    EXPECT_TRUE(checkSetupMemory(setup, {}, forecast.expected));
    EXPECT_FALSE(checkSetupMemory(setup, {}, zmapBytes(grid)));
    setup.shape.kind = StockKind::cylinder;
    EXPECT_GT(memoryForecast(setup, grid, {}).most, forecast.most) << "its uncut map is kept";
}

} // namespace
} // namespace proveout
