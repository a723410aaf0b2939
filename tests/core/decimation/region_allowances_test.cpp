// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/region_allowances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "core/decimation/regions/error_measure.h"
#include "core/decimation/surface/refined_surface.h"
#include "tests/core/decimation/hard_maps.h"
#include "tests/core/decimation/surface_oracle.h"
#include "tests/core/decimation/topology.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr double kSmallest = 0.01;

TEST(RegionAllowances, AreTheSmallestEverywhereUntilAViewIsFollowed) {
    const RegionAllowances allowances(RegionGrid(33, 33, 16), kSmallest);
    EXPECT_EQ(allowances.region(3), kSmallest);
    EXPECT_EQ(allowances.border(0), kSmallest);
}

TEST(RegionAllowances, NeverExceedWhatTheViewCanDrawAndDoNotFlicker) {
    const RegionGrid grid(3, 2, 2); // one region
    RegionAllowances allowances(grid, kSmallest);
    std::mt19937 random(5);
    std::size_t changes = 0;
    double wanted = 0.05;
    for (int step = 0; step < 5000; ++step) { // varies by a tenth around a step
        const double trembling = 0.04 * (0.9 + 0.2 * static_cast<double>(random()) / 4294967296.0);
        changes += allowances.follow(std::vector<double>{trembling}).size();
        EXPECT_LE(allowances.region(0), trembling);
    }
    EXPECT_LE(changes, 2U);
    for (int step = 0; step < 5000; ++step) {
        wanted =
            std::clamp(wanted * std::exp((static_cast<double>(random()) / 4294967296.0 - 0.5)), 1e-4, 100.0);
        (void)allowances.follow(std::vector<double>{wanted});
        const double found = allowances.region(0);
        EXPECT_LE(found, std::max(wanted, kSmallest));
        const double ceiling = std::ldexp(kSmallest, RegionAllowances::kMostSteps);
        EXPECT_GT(found * 2 * RegionAllowances::kSlack, std::min(wanted, ceiling)) << "coarser was possible";
        const double power = std::log2(found / kSmallest);
        EXPECT_EQ(power, std::round(power));
    }
}

TEST(RegionAllowances, ReportWhoseMeshOrBorderHadAnother) {
    const RegionGrid grid(41, 11, 10); // four in a row
    RegionAllowances allowances(grid, 1);
    EXPECT_EQ(allowances.follow(std::vector<double>{1, 1, 2, 1}), std::vector<std::size_t>{})
        << "needs the slack";
    EXPECT_EQ(allowances.follow(std::vector<double>{1, 1, 5, 1}), std::vector<std::size_t>{2})
        << "the borders keep the smaller allowance";
    EXPECT_EQ(allowances.follow(std::vector<double>{1, 1, 5, 5}), (std::vector<std::size_t>{2, 3}))
        << "the border between them is coarser now";
    EXPECT_EQ(allowances.follow(std::vector<double>{1, 1, 5, 5}), std::vector<std::size_t>{});
    EXPECT_EQ(allowances.border(grid.border(2, Side::east)), 4);
    EXPECT_EQ(allowances.border(grid.border(2, Side::west)), 1);
}

/// Dirty or not, finely next to coarsely decimated: no crack, no T-vertex and no flipped triangle after any
/// of thousands of steps, and every region within its own allowance.
TEST(MixedAllowances, HalfDirtySurfacesStayWholeAndKeepEachAllowance) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    int steps = 0;
    for (int round = 0; round < 150; ++round) {
        test::HardMap map = test::hardMap(static_cast<std::uint32_t>(random()), 44);
        DecimationParameters parameters;
        parameters.regionCells = std::array{2, 3, 4, 7, 16}[random() % 5];
        parameters.allowance = 0.01 * static_cast<double>(1 + random() % 20);
        parameters.level = random() % 2 == 0 ? ErrorLevel::sample : ErrorLevel::surface;
        SCOPED_TRACE(map.kind + ", region " + std::to_string(parameters.regionCells));
        Surface surface(map.nx, map.ny, parameters);
        std::vector<double> wanted(surface.grid().regionCount(), parameters.allowance);
        ZMapSnapshot zmap = test::zmapOf(map.nx, map.ny, map.spacing, map.heights);
        for (int step = 0; step < 40; ++step, ++steps) {
            const std::size_t point = random() % map.heights.size();
            switch (random() % 3) {
            case 0: { // a cut
                map.heights[point] -= 0.3F;
                zmap = test::zmapOf(map.nx, map.ny, map.spacing, map.heights);
                const int i = static_cast<int>(point) % map.nx;
                const int j = static_cast<int>(point) / map.nx;
                surface.touch({i, j, i + 1, j + 1});
                break;
            }
            case 1: // the view moves
                for (double& one : wanted)
                    if (random() % 4 == 0)
                        one = parameters.allowance * std::exp2(random() % 6);
                surface.followView(wanted);
                break;
            default: { // some regions are decimated
                std::vector<std::size_t> due;
                for (std::size_t region = 0; region < wanted.size(); ++region)
                    if (surface.isDirty(region) && random() % 2 == 0)
                        due.push_back(region);
                surface.decimateRegions(due, zmap);
            }
            }
            const SurfaceSnapshot shown = surface.snapshot();
            const std::vector<LatticeTriangle> triangles = shown.triangles();
            ASSERT_EQ(shown.faces, triangles.size());
            test::expectCoversMap(map.nx, map.ny, triangles);
            if (step % 5 != 4)
                continue;
            surface.decimateDirty(zmap);
            ASSERT_EQ(surface.snapshot().dirtyRegions, 0);
            for (std::size_t region = 0; region < wanted.size(); ++region) {
                const auto own = surface.snapshot().triangles(region);
                const double allowance = surface.allowance(region);
                ASSERT_LE(allowance, wanted[region]);
                ASSERT_EQ(surface.mesh(region)->allowance, allowance);
                const double error =
                    parameters.level == ErrorLevel::surface
                        ? test::edgesDistance(map.nx, map.heights, own)
                        : measureVerticalError(zmap, surface.grid().points(region), own, 0).largest;
                ASSERT_LE(error, allowance);
                ASSERT_LE(error, surface.mesh(region)->largestError);
            }
        }
        ASSERT_FALSE(testing::Test::HasFailure());
    }
    EXPECT_GE(steps, 5000);
}

TEST(MixedAllowances, OnlyRegionsOfTheSameAllowanceMerge) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (int round = 0; round < 40; ++round) {
        const test::HardMap map = test::hardMap(static_cast<std::uint32_t>(random()), 80);
        DecimationParameters parameters;
        parameters.regionCells = std::array{4, 8, 16}[random() % 3];
        parameters.allowance = 0.02;
        RefinedSurface surface(map.nx, map.ny, parameters);
        const RegionGrid grid = surface.grid();
        std::vector<double> wanted(grid.regionCount());
        const ZMapSnapshot zmap = test::zmapOf(map.nx, map.ny, map.spacing, map.heights);
        for (int move = 0; move < 3; ++move) {
            const int edge = static_cast<int>(random() % 80U); // close to the eye and far from it
            for (std::size_t region = 0; region < wanted.size(); ++region)
                wanted[region] = grid.points(region).i0 < edge ? 0.02 : 0.2;
            surface.followView(wanted);
            ASSERT_TRUE(surface.follow(zmap, {}));
            const SurfaceSnapshot shown = surface.snapshot();
            const auto triangles = shown.triangles();
            test::expectCoversMap(map.nx, map.ny, triangles);
            for (std::size_t region = 0; region < wanted.size(); ++region) {
                const auto own = shown.triangles(region);
                const double allowance = shown.meshes[region]->allowance;
                ASSERT_LE(test::edgesDistance(map.nx, map.heights, own), allowance);
                ASSERT_TRUE(own.empty() || allowance <= wanted[region]);
            }
        }
    }
}

} // namespace
} // namespace proveout
