// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the rows of the statistics with a recount that uses z-maps and surfaces, but no simulator.
#include <algorithm>
#include <gtest/gtest.h>
#include <optional>
#include <set>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

/// The definition, point by point: regions in which a height differs between two moments.
std::set<std::size_t> changedRegions(const ZMapSnapshot& a, const ZMapSnapshot& b, const RegionGrid& grid) {
    std::set<std::size_t> changed;
    for (std::size_t region = 0; region < grid.regionCount(); ++region) {
        const IndexRect rect = grid.points(region);
        for (int j = rect.j0; j < rect.j1; ++j)
            for (int i = rect.i0; i < rect.i1; ++i)
                if (a.height(i, j) != b.height(i, j))
                    changed.insert(region);
    }
    return changed;
}

std::set<std::size_t> dirtyRegions(const SurfaceSnapshot& surface) {
    std::set<std::size_t> dirty;
    for (std::size_t region = 0; region < surface.meshes.size(); ++region)
        if (!surface.meshes[region])
            dirty.insert(region);
    return dirty;
}

double deepest(const ZMapSnapshot& before, const ZMapSnapshot& after) {
    float depth = 0;
    for (int j = 0; j < before.grid().ny; ++j)
        for (int i = 0; i < before.grid().nx; ++i)
            depth = std::max(depth, before.height(i, j) - after.height(i, j));
    return static_cast<double>(depth);
}

std::size_t trianglesOf(const SurfaceSnapshot& surface) {
    return surface.triangles().size();
}

std::optional<std::size_t> lastMoment(int period, std::size_t block) {
    if (period == 0)
        return std::nullopt;
    return period < 0 ? 0 : block / static_cast<std::size_t>(period) * static_cast<std::size_t>(period);
}

class Statistics : public testing::TestWithParam<int> {};

TEST_P(Statistics, AgreeWithARecount) {
    const int period = GetParam();
    DecimationParameters parameters;
    parameters.period = period;
    const auto program = programOf(randomProgram(77, 90));
    const auto frames = straightRun(program, smallSetup(), parameters);
    const auto& rows = frames.back().statistics;
    ASSERT_EQ(rows.size(), program->blockCount());
    const RegionGrid& regions = frames.front().surface.grid;
    const auto& grid = frames.front().zmap.grid();
    const auto facesFull = static_cast<std::uint32_t>(2 * (grid.nx - 1) * (grid.ny - 1));
    bool everDirty = false;
    bool everDecimated = false;

    for (std::size_t block = 1; block <= program->blockCount(); ++block) {
        SCOPED_TRACE(testing::Message() << "block " << block);
        const Frame& frame = frames[block];
        const BlockStatistics& row = rows[block - 1];
        const auto moment = lastMoment(period, block);
        std::set<std::size_t> dirty;
        if (moment)
            dirty = changedRegions(frames[*moment].zmap, frame.zmap, regions);
        else
            for (std::size_t region = 0; region < regions.regionCount(); ++region)
                dirty.insert(region);
        EXPECT_EQ(dirtyRegions(frame.surface), dirty);
        EXPECT_EQ(row.regionsDirty, dirty.size());
        EXPECT_EQ(row.facesFull, facesFull);
        EXPECT_EQ(row.facesShown, trianglesOf(frame.surface));

        std::size_t decimated = 0;
        if (moment == block && period > 0)
            decimated =
                changedRegions(frames[block - static_cast<std::size_t>(period)].zmap, frame.zmap, regions)
                    .size();
        EXPECT_EQ(row.regionsDecimated, decimated);

        const double volume = frames[block - 1].zmap.volume() - frame.zmap.volume();
        EXPECT_NEAR(row.removedMm3, volume, 1e-3 + 1e-4 * volume);
        EXPECT_FLOAT_EQ(row.maxDepth, static_cast<float>(deepest(frames[block - 1].zmap, frame.zmap)));
        everDirty = everDirty || !dirty.empty();
        everDecimated = everDecimated || decimated > 0;
    }
    EXPECT_TRUE(everDirty || period == 1);
    EXPECT_EQ(everDecimated, period > 0);
    const double removed = frames.front().zmap.volume() - frames.back().zmap.volume();
    EXPECT_NEAR(frames.back().removedMm3, removed, 1e-5 * removed);
}

INSTANTIATE_TEST_SUITE_P(Periods, Statistics, testing::Values(-1, 0, 1, 20));

TEST(Schedule, OnceAtTheStartShowsTheUncutStockDecimated) {
    DecimationParameters parameters;
    parameters.period = -1;
    const auto program = programOf(randomProgram(3, 40));
    const auto frames = straightRun(program, smallSetup(), parameters);
    EXPECT_EQ(frames.front().surface.dirtyRegions, 0U);
    EXPECT_LT(frames.front().surface.faces, frames.front().surface.facesFull / 10);
    for (std::size_t block = 1; block < frames.size(); ++block)
        EXPECT_GE(frames[block].surface.dirtyRegions, frames[block - 1].surface.dirtyRegions);
}

TEST(Schedule, NothingIsDecimatedWithoutAnAllowance) {
    DecimationParameters parameters;
    parameters.allowance = 0;
    const auto frames = straightRun(programOf(randomProgram(3, 40)), smallSetup(), parameters);
    for (const Frame& frame : frames)
        EXPECT_EQ(frame.surface.faces, frame.surface.facesFull);
}

TEST(Statistics, RowsOfBlocksAheadStayAfterASeekBack) {
    const auto program = programOf(randomProgram(9, 60));
    const auto simulation = startedSimulation(program, smallSetup(), {});
    simulation->seek(60);
    simulation->seek(10);
    const Frame frame = simulation->frame();
    EXPECT_EQ(frame.block, 10U);
    EXPECT_EQ(frame.statistics.size(), 60U);
}

} // namespace
} // namespace proveout
