// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/surface/surface.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <random>
#include <string>

#include "core/decimation/regions/error_measure.h"
#include "tests/core/decimation/maps.h"
#include "tests/core/decimation/topology.h"

namespace proveout {
namespace {

using test::Heights;

DecimationParameters withRegion(int cells, double allowance) {
    DecimationParameters parameters = test::leeParameters();
    parameters.regionCells = cells;
    parameters.allowance = allowance;
    return parameters;
}

/// Recomputes everything that the snapshot reports about itself, and checks its topology.
void expectConsistent(const SurfaceSnapshot& surface) {
    const std::vector<LatticeTriangle> triangles = surface.triangles();
    EXPECT_EQ(surface.faces, triangles.size());
    std::size_t dirty = 0;
    std::size_t full = 0;
    std::size_t byRegion = 0;
    for (std::size_t region = 0; region < surface.grid.regionCount(); ++region) {
        dirty += surface.meshes[region] ? 0 : 1;
        full += fullRegionFaces(surface.grid, region);
        byRegion += surface.triangles(region).size();
    }
    EXPECT_EQ(surface.dirtyRegions, dirty);
    EXPECT_EQ(surface.facesFull, full);
    EXPECT_EQ(surface.faces, byRegion);
    for (std::size_t border = 0; border < surface.grid.borderCount(); ++border) {
        bool anyDecimated = false;
        for (const std::size_t region : surface.grid.sharers(border))
            anyDecimated |= region != RegionGrid::kNoRegion && surface.meshes[region] != nullptr;
        EXPECT_EQ(surface.borders[border] != nullptr, anyDecimated);
    }
    test::expectCoversMap(surface.grid.nx(), surface.grid.ny(), triangles);
}

bool sameMeshes(const SurfaceSnapshot& a, const SurfaceSnapshot& b) {
    if (!(a.grid == b.grid) || a.faces != b.faces)
        return false;
    for (std::size_t region = 0; region < a.grid.regionCount(); ++region) {
        if ((a.meshes[region] == nullptr) != (b.meshes[region] == nullptr))
            return false;
        if (a.meshes[region] && (a.meshes[region]->triangles != b.meshes[region]->triangles ||
                                 a.meshes[region]->largestError != b.meshes[region]->largestError))
            return false;
    }
    for (std::size_t border = 0; border < a.grid.borderCount(); ++border) {
        if ((a.borders[border] == nullptr) != (b.borders[border] == nullptr))
            return false;
        if (a.borders[border] && a.borders[border]->kept != b.borders[border]->kept)
            return false;
    }
    return true;
}

TEST(Surface, startsWithTheFullMesh) {
    const Surface surface(20, 11, withRegion(8, 0.05));
    EXPECT_EQ(surface.faces(), 2U * 19 * 10);
    EXPECT_EQ(surface.dirtyRegions(), 6U);
    expectConsistent(surface.snapshot());
}

/// Two triangles per region would be sufficient. A single pass (paper §4) leaves a few vertices whose
/// collapses were all degenerate when they were examined.
TEST(Surface, flatStockBecomesHardlyMoreThanTwoTrianglesARegion) {
    Surface surface(65, 33, withRegion(8, 0.05));
    const ZMapSnapshot zmap = test::zmapOf(65, 33, 1, Heights(65 * 33, 0.0F));
    EXPECT_EQ(surface.decimateDirty(zmap), 32U);
    EXPECT_GE(surface.faces(), 64U);
    EXPECT_LE(surface.faces(), 96U);
    EXPECT_EQ(surface.snapshot().largestError(), 0);
    expectConsistent(surface.snapshot());
}

TEST(Surface, withoutAllowanceOrMethodNothingIsDecimated) {
    const ZMapSnapshot zmap = test::zmapOf(20, 20, 1, Heights(400, 0.0F));
    Surface exact(20, 20, withRegion(8, 0));
    EXPECT_EQ(exact.decimateDirty(zmap), 0U);
    EXPECT_EQ(exact.faces(), exact.facesFull());
    DecimationParameters parameters = test::leeParameters();
    parameters.method = DecimationMethod::none;
    Surface none(20, 20, parameters);
    EXPECT_EQ(none.decimateDirty(zmap), 0U);
    EXPECT_EQ(none.faces(), none.facesFull());
}

TEST(Surface, globalIsOneRegion) {
    DecimationParameters parameters = test::leeParameters();
    parameters.method = DecimationMethod::global;
    Surface surface(50, 31, parameters);
    EXPECT_EQ(surface.grid().regionCount(), 1U);
    EXPECT_EQ(surface.decimateDirty(test::zmapOf(50, 31, 1, Heights(1550, -2.0F))), 1U);
    EXPECT_LE(surface.faces(), 30U);
}

TEST(Surface, touchReportsHowManyWereDecimatedBefore) {
    Surface surface(33, 33, withRegion(8, 0.05));
    const ZMapSnapshot zmap = test::zmapOf(33, 33, 1, Heights(33 * 33, 0.0F));
    EXPECT_EQ(surface.touch({0, 0, 33, 33}), 0U);
    EXPECT_EQ(surface.decimateDirty(zmap), 16U);
    EXPECT_EQ(surface.touch({3, 3, 5, 5}), 1U);
    EXPECT_EQ(surface.touch({8, 8, 9, 9}), 3U); // a corner point makes all four regions that contain it dirty
    EXPECT_EQ(surface.touch({-5, -5, 0, 0}), 0U);
    EXPECT_EQ(surface.dirtyRegions(), 4U);
    expectConsistent(surface.snapshot());
}

/// Cuts, makes dirty and decimates at random, and checks every state: no crack, no T-vertex and no flipped
/// face in any mix of decimated and dirty regions.
TEST(Surface, hasNoCrackInAnyHalfDirtyState) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const auto pick = [&](int limit) {
            return static_cast<int>(random() % static_cast<unsigned>(limit));
        };
        const int nx = 2 + pick(60);
        const int ny = 2 + pick(60);
        const auto& kind = test::mapKinds()[static_cast<std::size_t>(pick(5))];
        const Heights heights = kind.make(nx, ny, 1, seed);
        const ZMapSnapshot zmap = test::zmapOf(nx, ny, 1, heights);
        DecimationParameters parameters = withRegion(2 + pick(14), 0.02 + 0.02 * pick(20));
        parameters.certify = pick(3) != 0;
        Surface surface(nx, ny, parameters);
        for (int step = 0; step < 40; ++step) {
            const int i = pick(nx);
            const int j = pick(ny);
            const int deed = pick(6);
            if (deed == 0) {
                surface.decimateDirty(zmap);
            } else if (deed == 1) {
                std::vector<std::size_t> some;
                for (std::size_t region = 0; region < surface.grid().regionCount(); ++region)
                    if (surface.isDirty(region) && pick(2) == 0)
                        some.push_back(region);
                surface.decimateRegions(some, zmap);
            } else {
                surface.touch({i, j, i + 1 + pick(10), j + 1 + pick(10)});
            }
            expectConsistent(surface.snapshot());
            if (HasFailure())
                return;
        }
    }
}

TEST(Surface, whatIsDirtyAndUndecimatedStaysWithinTheAllowanceToo) {
    for (const auto& kind : test::mapKinds()) {
        SCOPED_TRACE(kind.name);
        const Heights heights = kind.make(70, 50, 0.5, 3);
        const ZMapSnapshot zmap = test::zmapOf(70, 50, 0.5, heights);
        Surface surface(70, 50, withRegion(8, 0.05));
        surface.decimateDirty(zmap);
        for (int k = 0; k < 20; ++k)
            surface.touchRegion(static_cast<std::size_t>(k * 3) % surface.grid().regionCount());
        const auto triangles = surface.snapshot().triangles();
        EXPECT_LE(test::bruteForceError(70, 50, heights, triangles), 0.05);
        EXPECT_EQ(measureVerticalError(zmap, {0, 0, 70, 50}, triangles, 0.05).beyond, 0U);
    }
}

TEST(Surface, dependsNeitherOnThreadsNorOnHowOneGotThere) {
    for (const BorderRule borders : {BorderRule::shared, BorderRule::paper}) {
        const Heights heights = test::mapKind("spheres").make(120, 90, 1, 8);
        const ZMapSnapshot zmap = test::zmapOf(120, 90, 1, heights);
        DecimationParameters parameters = withRegion(8, 0.05);
        parameters.borders = borders;
        Surface alone(120, 90, parameters);
        {
            const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
            alone.decimateDirty(zmap);
        }
        Surface many(120, 90, parameters);
        const tbb::global_control fourThreads(tbb::global_control::max_allowed_parallelism, 4);
        many.decimateDirty(zmap);
        EXPECT_TRUE(sameMeshes(alone.snapshot(), many.snapshot()));
        many.touch({20, 20, 60, 40});
        EXPECT_FALSE(sameMeshes(alone.snapshot(), many.snapshot()));
        many.decimateDirty(zmap);
        EXPECT_TRUE(sameMeshes(alone.snapshot(), many.snapshot()));
    }
}

TEST(Surface, copiesDecimateApartFromOneAnother) {
    const ZMapSnapshot zmap = test::zmapOf(40, 40, 1, test::mapKind("terrain").make(40, 40, 1, 2));
    Surface original(40, 40, withRegion(8, 0.05));
    original.decimateDirty(zmap);
    original.touch({0, 0, 10, 10});
    const SurfaceSnapshot before = original.snapshot();
    Surface copy = original;
    copy.decimateDirty(zmap);
    EXPECT_EQ(copy.dirtyRegions(), 0U);
    EXPECT_TRUE(sameMeshes(before, original.snapshot()));
    expectConsistent(copy.snapshot());
}

TEST(Surface, aStoppedContextLeavesAValidState) {
    const ZMapSnapshot zmap = test::zmapOf(200, 200, 1, test::mapKind("terrain").make(200, 200, 1, 2));
    Surface surface(200, 200, withRegion(8, 0.05));
    std::stop_source source;
    std::vector<double> reported;
    WorkContext context;
    context.stop = source.get_token();
    context.progress = [&](double done) {
        reported.push_back(done);
        if (done > 0.3)
            source.request_stop();
    };
    const std::size_t done = surface.decimateDirty(zmap, context);
    EXPECT_GT(done, 0U);
    EXPECT_LT(done, surface.grid().regionCount());
    EXPECT_EQ(surface.dirtyRegions(), surface.grid().regionCount() - done);
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
    expectConsistent(surface.snapshot());
    EXPECT_EQ(surface.decimateDirty(zmap, context), 0U);
    surface.decimateDirty(zmap);
    EXPECT_EQ(surface.dirtyRegions(), 0U);
    expectConsistent(surface.snapshot());
}

} // namespace
} // namespace proveout
