// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/surface/refined_surface.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <thread>
#include <utility>

#include "tests/core/decimation/hard_maps.h"
#include "tests/core/decimation/surface_oracle.h"
#include "tests/core/decimation/topology.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using test::Heights;

DecimationParameters certified(int region, double allowance, ErrorLevel level = ErrorLevel::surface) {
    return test::certifiedParameters(region, allowance, level);
}

/// Recomputes everything that a snapshot reports about itself, and checks what must hold for every surface.
void expectHolds(const SurfaceSnapshot& surface, const Heights& heights,
                 const DecimationParameters& parameters) {
    const int nx = surface.grid.nx();
    const int ny = surface.grid.ny();
    const std::vector<LatticeTriangle> triangles = surface.triangles();
    EXPECT_EQ(surface.faces, triangles.size());
    EXPECT_EQ(surface.dirtyRegions, 0U);
    test::expectCoversMap(nx, ny, triangles);
    const test::SurfaceDistance distance = test::surfaceDistance(nx, ny, heights, triangles);
    const double error = parameters.level == ErrorLevel::surface ? distance.surface : distance.samples;
    EXPECT_LE(error, parameters.allowance);
    EXPECT_LE(error, surface.largestError());
    EXPECT_LE(surface.largestError(), parameters.allowance);
}

TEST(RefinedSurface, keepsTheAllowanceOnHardMapsWithRegionsOfAnySize) {
    for (std::uint32_t seed = 0; seed < 240; ++seed) {
        std::mt19937 random(seed);
        const test::HardMap map = test::hardMap(seed, 110);
        const double allowance = 0.001 * std::pow(1000.0, static_cast<double>(random()) / 4294967296.0);
        const int region = std::array{4, 5, 8, 16, 33, 64}[random() % 6];
        const auto level = random() % 3 == 0 ? ErrorLevel::sample : ErrorLevel::surface;
        const DecimationParameters parameters = certified(region, allowance, level);
        SCOPED_TRACE(map.kind + " of seed " + std::to_string(seed) + ", region " + std::to_string(region));
        RefinedSurface surface(map.nx, map.ny, parameters);
        ASSERT_TRUE(surface.follow(test::zmapOf(map.nx, map.ny, map.spacing, map.heights), {}));
        expectHolds(surface.snapshot(), map.heights, parameters);
    }
}

TEST(RefinedSurface, hasFewerFacesThanRegionsByThemselves) {
    constexpr int kSize = 257;
    for (const char* kind : {"terrain", "walls", "spheres"}) {
        const Heights heights = test::mapKind(kind).make(kSize, kSize, 0.2, 8);
        const ZMapSnapshot zmap = test::zmapOf(kSize, kSize, 0.2, heights);
        const DecimationParameters parameters = certified(16, 0.05);
        Surface alone(kSize, kSize, parameters);
        alone.decimateDirty(zmap);
        std::size_t before = alone.faces();
        for (const int most : {32, 64, 128, 256}) {
            RefinedSurface merged(kSize, kSize, parameters, most);
            ASSERT_TRUE(merged.follow(zmap, {}));
            EXPECT_LT(merged.snapshot().faces, before) << kind << ", " << most;
            before = merged.snapshot().faces;
        }
    }
}

TEST(RefinedSurface, ofAPlaneIsTwoTriangles) {
    Heights heights;
    for (int j = 0; j < 200; ++j)
        for (int i = 0; i < 150; ++i)
            heights.push_back(static_cast<float>(-10 - 0.125 * i + 0.25 * j));
    RefinedSurface surface(150, 200, certified(8, 0.001));
    ASSERT_TRUE(surface.follow(test::zmapOf(150, 200, 1, heights), {}));
    EXPECT_EQ(surface.snapshot().faces, 2U);
}

TEST(RefinedSurface, reportsItsProgressRisingOnItsOwnThread) {
    const ZMapSnapshot zmap = test::zmapOf(301, 257, 0.2, test::mapKind("spheres").make(301, 257, 0.2, 8));
    RefinedSurface surface(301, 257, certified(16, 0.05));
    double last = 0;
    std::size_t reported = 0;
    const auto self = std::this_thread::get_id();
    ASSERT_TRUE(surface.follow(zmap, {}, {{}, [&](double done) {
                                              EXPECT_GE(done, last);
                                              EXPECT_LE(done, 1 + 1e-9);
                                              EXPECT_EQ(std::this_thread::get_id(), self);
                                              last = done;
                                              ++reported;
                                          }}));
    EXPECT_GT(reported, 50U);
    EXPECT_GT(last, 0.9);
}

/// Lowers a random disc; returns its bounding rectangle.
IndexRect cutDisc(std::mt19937& random, int nx, int ny, Heights& heights) {
    const int ci = static_cast<int>(random() % static_cast<unsigned>(nx));
    const int cj = static_cast<int>(random() % static_cast<unsigned>(ny));
    const int radius = 1 + static_cast<int>(random() % 12);
    const float depth = static_cast<float>(random() % 2000) * -0.01F;
    const IndexRect rect{std::max(0, ci - radius), std::max(0, cj - radius), std::min(nx, ci + radius + 1),
                         std::min(ny, cj + radius + 1)};
    for (int j = rect.j0; j < rect.j1; ++j) {
        for (int i = rect.i0; i < rect.i1; ++i) {
            const int away = (i - ci) * (i - ci) + (j - cj) * (j - cj);
            float& height = heights[static_cast<std::size_t>(j * nx + i)];
            if (away <= radius * radius)
                height = std::min(height, depth + 0.05F * static_cast<float>(away));
        }
    }
    return rect;
}

std::vector<std::size_t> regionsIn(const RegionGrid& grid, const IndexRect& rect) {
    std::vector<std::size_t> regions;
    const IndexRect touched = grid.regionsTouching(rect);
    for (int ry = touched.j0; ry < touched.j1; ++ry)
        for (int rx = touched.i0; rx < touched.i1; ++rx)
            regions.push_back(grid.regionAt(rx, ry));
    return regions;
}

TEST(RefinedSurface, afterAnyWalkOfCutsIsWhatItWouldBeFromScratch) {
    constexpr int kNx = 131;
    constexpr int kNy = 90;
    const int steps = std::max(12, roundsOf(60));
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (const ErrorLevel level : {ErrorLevel::surface, ErrorLevel::sample}) {
        const DecimationParameters parameters = certified(12, 0.03, level);
        Heights heights(static_cast<std::size_t>(kNx) * kNy, 0.0F);
        RefinedSurface walking(kNx, kNy, parameters);
        ASSERT_TRUE(walking.follow(test::zmapOf(kNx, kNy, 1, heights), {}));
        for (int step = 0; step < steps; ++step) {
            const IndexRect rect = cutDisc(random, kNx, kNy, heights);
            const ZMapSnapshot zmap = test::zmapOf(kNx, kNy, 1, heights);
            std::vector<std::size_t> changed = regionsIn(walking.grid(), rect);
            if (random() % 4 == 0) { // stopped at some point, and called again
                std::stop_source source;
                int reported = 0;
                const int enough = static_cast<int>(random() % 8);
                const WorkContext context{source.get_token(), [&](double) {
                                              if (++reported > enough)
                                                  source.request_stop();
                                          }};
                if (random() % 2 == 0)
                    source.request_stop();
                (void)walking.follow(zmap, changed, context);
                changed.clear();
            }
            ASSERT_TRUE(walking.follow(zmap, changed));
            RefinedSurface fresh(kNx, kNy, parameters);
            ASSERT_TRUE(fresh.follow(zmap, {}));
            ASSERT_EQ(walking.snapshot().triangles(), fresh.snapshot().triangles()) << "step " << step;
            if (step % 10 == 9)
                expectHolds(walking.snapshot(), heights, parameters);
        }
    }
}

TEST(RefinedSurface, keepsTheMeshesOfWhatDidNotChange) {
    constexpr int kSize = 513;
    Heights heights = test::mapKind("terrain").make(kSize, kSize, 0.5, 4);
    RefinedSurface surface(kSize, kSize, certified(16, 0.05), 128);
    ASSERT_TRUE(surface.follow(test::zmapOf(kSize, kSize, 0.5, heights), {}));
    const SurfaceSnapshot before = surface.snapshot();
    heights[200 * kSize + 200] = -90;
    const auto changed = regionsIn(surface.grid(), {200, 200, 201, 201});
    ASSERT_TRUE(surface.follow(test::zmapOf(kSize, kSize, 0.5, heights), changed));
    std::size_t others = 0;
    for (std::size_t region = 0; region < before.meshes.size(); ++region)
        others += surface.snapshot().meshes[region] != before.meshes[region] ? 1 : 0;
    EXPECT_GE(others, 1U);
    EXPECT_LE(others, 4U) << "of the sixteen merged blocks";
}

TEST(RefinedSurface, isTheSameWithAnyNumberOfThreads) {
    constexpr int kSize = 257;
    const Heights heights = test::mapKind("spheres").make(kSize, kSize, 0.2, 5);
    const ZMapSnapshot zmap = test::zmapOf(kSize, kSize, 0.2, heights);
    std::vector<std::vector<LatticeTriangle>> meshes;
    for (const std::size_t threads : {1U, 2U, 8U}) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        meshes.push_back(decimatedWhole(zmap, certified(16, 0.02)).triangles());
    }
    EXPECT_EQ(meshes[0], meshes[1]);
    EXPECT_EQ(meshes[0], meshes[2]);
}

TEST(RefinedSurface, leavesBlocksOfNoiseInParts) {
    constexpr int kSize = 401;
    const Heights heights = test::mapKind("noise").make(kSize, kSize, 0.5, 9);
    const DecimationParameters parameters = certified(16, 0.001);
    RefinedSurface surface(kSize, kSize, parameters);
    ASSERT_TRUE(surface.follow(test::zmapOf(kSize, kSize, 0.5, heights), {}));
    std::size_t largest = 0;
    for (std::size_t region = 0; region < surface.grid().regionCount(); ++region)
        largest = std::max(largest, surface.snapshot().meshes[region]->triangles.size());
    EXPECT_GT(surface.snapshot().faces, RefinedSurface::kMostTriangles);
    EXPECT_LE(largest, RefinedSurface::kMostTriangles);
    expectHolds(surface.snapshot(), heights, parameters);
}

TEST(RefinedSurface, leavesRegionsAloneWhoseHeightsAreTooCoarse) {
    constexpr int kSize = 65;
    Heights heights(kSize * kSize, 0.0F);
    for (int j = 0; j < 20; ++j)
        for (int i = 0; i < 20; ++i)
            heights[static_cast<std::size_t>(j * kSize + i)] = (i + j) % 2 == 0 ? 0.0F : 1e6F;
    const DecimationParameters parameters = certified(16, 0.001);
    RefinedSurface surface(kSize, kSize, parameters);
    ASSERT_TRUE(surface.follow(test::zmapOf(kSize, kSize, 1, heights), {}));
    EXPECT_LT(surface.snapshot().faces, surface.snapshot().facesFull / 2);
    expectHolds(surface.snapshot(), heights, parameters);
}

} // namespace
} // namespace proveout
