// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/certified/certified_decimator.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <random>
#include <string>

#include "core/decimation/surface/surface.h"
#include "tests/core/decimation/hard_maps.h"
#include "tests/core/decimation/surface_oracle.h"
#include "tests/core/decimation/topology.h"

namespace proveout {
namespace {

using test::HardMap;
using test::Heights;

SurfaceSnapshot decimated(const HardMap& map, const DecimationParameters& parameters) {
    Surface surface(map.nx, map.ny, parameters);
    surface.decimateDirty(test::zmapOf(map.nx, map.ny, map.spacing, map.heights));
    EXPECT_EQ(surface.dirtyRegions(), 0U);
    return surface.snapshot();
}

struct RandomCase {
    HardMap map;
    DecimationParameters parameters;
};

RandomCase randomCase(std::uint32_t seed, ErrorLevel level) {
    constexpr std::array kRegions{4, 5, 8, 16, 33, 64, 100, 256};
    std::mt19937 random(seed);
    RandomCase made;
    made.map = test::hardMap(seed, level == ErrorLevel::surface ? 90 : 150);
    const double allowance = 0.001 * std::pow(1000.0, static_cast<double>(random()) / 4294967296.0);
    made.parameters = test::certifiedParameters(kRegions[random() % kRegions.size()], allowance, level);
    return made;
}

std::string report(std::uint32_t seed, const RandomCase& made) {
    return made.map.kind + " of seed " + std::to_string(seed) + ", " + std::to_string(made.map.nx) + " x " +
           std::to_string(made.map.ny) + ", region " + std::to_string(made.parameters.regionCells) +
           ", allowance " + std::to_string(made.parameters.allowance);
}

constexpr std::uint32_t kSeeds = 360;

TEST(Certified, keepsEveryPointWithinTheAllowance) {
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        const RandomCase made = randomCase(seed, ErrorLevel::sample);
        const HardMap& map = made.map;
        SCOPED_TRACE(report(seed, made));
        const SurfaceSnapshot surface = decimated(map, made.parameters);
        const std::vector<LatticeTriangle> triangles = surface.triangles();
        const double error = test::surfaceDistance(map.nx, map.ny, map.heights, triangles).samples;
        EXPECT_LE(error, made.parameters.allowance);
        EXPECT_LE(error, surface.largestError());
        EXPECT_LE(surface.largestError(), made.parameters.allowance);
        test::expectCoversMap(map.nx, map.ny, triangles);
    }
}

TEST(Certified, keepsTheWholeSurfaceWithinTheAllowance) {
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        const RandomCase made = randomCase(seed, ErrorLevel::surface);
        const HardMap& map = made.map;
        SCOPED_TRACE(report(seed, made));
        const std::vector<LatticeTriangle> triangles = decimated(map, made.parameters).triangles();
        EXPECT_LE(test::surfaceDistance(map.nx, map.ny, map.heights, triangles).surface,
                  made.parameters.allowance);
        test::expectCoversMap(map.nx, map.ny, triangles);
    }
}

/// The control of the two tests above: at walls the errors at the points say nothing about the surface
/// between them.
TEST(Certified, atSampleLevelIsSeenToLeaveTheSurfaceAtWalls) {
    HardMap map;
    map.nx = map.ny = 65;
    map.heights = test::mapKind("walls").make(65, 65, 0.5, 3);
    const std::vector<LatticeTriangle> triangles =
        decimated(map, test::certifiedParameters(64, 0.05, ErrorLevel::sample)).triangles();
    const test::SurfaceDistance distance = test::surfaceDistance(65, 65, map.heights, triangles);
    EXPECT_LE(distance.samples, 0.05);
    EXPECT_GT(distance.surface, 0.05);
}

TEST(Certified, dirtyRegionsMeetDecimatedOnesWithoutACrack) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const RandomCase made = randomCase(seed, seed % 2 == 0 ? ErrorLevel::sample : ErrorLevel::surface);
        SCOPED_TRACE(report(seed, made));
        Surface surface(made.map.nx, made.map.ny, made.parameters);
        const ZMapSnapshot zmap = test::zmapOf(made.map.nx, made.map.ny, made.map.spacing, made.map.heights);
        surface.decimateDirty(zmap);
        std::mt19937 random(seed);
        for (int round = 0; round < 3; ++round) {
            std::vector<std::size_t> again;
            for (std::size_t region = 0; region < surface.grid().regionCount(); ++region) {
                if (random() % 5 == 0)
                    surface.touchRegion(region);
                if (surface.isDirty(region) && random() % 2 == 0)
                    again.push_back(region);
            }
            test::expectCoversMap(made.map.nx, made.map.ny, surface.snapshot().triangles());
            surface.decimateRegions(again, zmap);
            for (const std::size_t region : again)
                EXPECT_FALSE(surface.isDirty(region));
            const std::vector<LatticeTriangle> triangles = surface.snapshot().triangles();
            EXPECT_EQ(surface.faces(), triangles.size());
            test::expectCoversMap(made.map.nx, made.map.ny, triangles);
            EXPECT_LE(test::surfaceDistance(made.map.nx, made.map.ny, made.map.heights, triangles).samples,
                      made.parameters.allowance);
        }
    }
}

TEST(Certified, givesTheSameMeshesWithAnyNumberOfThreads) {
    for (const ErrorLevel level : {ErrorLevel::sample, ErrorLevel::surface}) {
        HardMap map;
        map.nx = map.ny = 257;
        map.heights = test::mapKind("spheres").make(257, 257, 0.2, 5);
        std::vector<std::vector<LatticeTriangle>> meshes;
        for (const std::size_t threads : {1U, 2U, 8U}) {
            const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
            meshes.push_back(decimated(map, test::certifiedParameters(32, 0.02, level)).triangles());
        }
        EXPECT_EQ(meshes[0], meshes[1]);
        EXPECT_EQ(meshes[0], meshes[2]);
    }
}

TEST(Certified, flatAndPlanarRegionsAreTwoTriangles) {
    for (const double slope : {0.0, -0.2}) {
        HardMap map;
        map.nx = map.ny = 129;
        for (int j = 0; j < 129; ++j)
            for (int i = 0; i < 129; ++i)
                map.heights.push_back(static_cast<float>(slope * i - 10));
        for (const ErrorLevel level : {ErrorLevel::sample, ErrorLevel::surface})
            EXPECT_EQ(decimated(map, test::certifiedParameters(64, 0.001, level)).faces, 8U);
    }
}

TEST(Certified, regionsWhoseHeightsAreTooCoarseStayFull) {
    HardMap map;
    map.nx = map.ny = 17;
    for (int k = 0; k < 17 * 17; ++k)
        map.heights.push_back(static_cast<float>(k % 2 == 0 ? 0 : 1e6));
    const SurfaceSnapshot surface = decimated(map, test::certifiedParameters(8, 0.001, ErrorLevel::surface));
    EXPECT_EQ(surface.faces, surface.facesFull);
}

} // namespace
} // namespace proveout
