// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lee/lee_decimator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <thread>

#include "core/decimation/regions/error_measure.h"
#include "core/decimation/surface/decimator_pool.h"
#include "core/decimation/surface/surface.h"
#include "tests/core/decimation/maps.h"
#include "tests/core/decimation/topology.h"

namespace proveout {
namespace {

using test::Heights;

struct Case {
    std::string map;
    int region;
    double allowance;
};

std::vector<Case> allCases() {
    std::vector<Case> cases;
    for (const auto& kind : test::mapKinds())
        for (const int region : {5, 8, 13, 16, 30, 64})
            for (const double allowance : {0.01, 0.05, 0.1})
                cases.push_back({kind.name, region, allowance});
    return cases;
}

class LeeOn : public testing::TestWithParam<Case> {
protected:
    static constexpr int kNx = 98; // leaves partial regions on both axes, with one cell for some region sizes
    static constexpr int kNy = 66;
    static constexpr double kSpacing = 0.5;

    SurfaceSnapshot decimated(const DecimationParameters& parameters) const {
        Surface surface(kNx, kNy, parameters);
        surface.decimateDirty(m_zmap);
        return surface.snapshot();
    }
    DecimationParameters parameters() const {
        DecimationParameters parameters = test::leeParameters();
        parameters.regionCells = GetParam().region;
        parameters.allowance = GetParam().allowance;
        return parameters;
    }
    VerticalError error(const std::vector<LatticeTriangle>& triangles) const {
        return measureVerticalError(m_zmap, {0, 0, kNx, kNy}, triangles, GetParam().allowance);
    }

    const Heights m_heights = test::mapKind(GetParam().map).make(kNx, kNy, kSpacing, 17);
    const ZMapSnapshot m_zmap = test::zmapOf(kNx, kNy, kSpacing, m_heights);
};

INSTANTIATE_TEST_SUITE_P(Maps, LeeOn, testing::ValuesIn(allCases()), [](const auto& param) {
    return param.param.map + "_" + std::to_string(param.param.region) + "_" +
           std::to_string(static_cast<int>(std::lround(1000 * param.param.allowance))) + "um";
});

TEST_P(LeeOn, certifiedKeepsEveryPointWithinTheAllowance) {
    const SurfaceSnapshot surface = decimated(parameters());
    const std::vector<LatticeTriangle> triangles = surface.triangles();
    test::expectCoversMap(kNx, kNy, triangles);
    EXPECT_EQ(surface.faces, triangles.size());
    EXPECT_LT(surface.faces, surface.facesFull);
    const VerticalError measured = error(triangles);
    EXPECT_LE(measured.largest, GetParam().allowance);
    EXPECT_EQ(measured.beyond, 0U);
    const double bruteForce = test::bruteForceError(kNx, kNy, m_heights, triangles);
    EXPECT_LE(bruteForce, GetParam().allowance);
    EXPECT_NEAR(measured.largest, bruteForce, 1e-12);
    EXPECT_NEAR(surface.largestError(), bruteForce, 1e-12);
}

TEST_P(LeeOn, uncertifiedReportsTheErrorThatIsMeasured) {
    DecimationParameters uncertified = parameters();
    uncertified.certify = false;
    const SurfaceSnapshot surface = decimated(uncertified);
    const std::vector<LatticeTriangle> triangles = surface.triangles();
    test::expectCoversMap(kNx, kNy, triangles);
    const VerticalError measured = error(triangles);
    EXPECT_EQ(measured.uncovered, 0U);
    EXPECT_NEAR(measured.largest, surface.largestError(), 1e-12);
    EXPECT_NEAR(measured.largest, test::bruteForceError(kNx, kNy, m_heights, triangles), 1e-12);
    RecordProperty("facesIn", static_cast<int>(surface.facesFull));
    RecordProperty("facesOut", static_cast<int>(surface.faces));
    RecordProperty("largestErrorMm", std::to_string(measured.largest));
    RecordProperty("pointsBeyond", static_cast<int>(measured.beyond));
}

TEST_P(LeeOn, withThePapersBordersEachRegionIsCoveredAndCertified) {
    DecimationParameters perRegion = parameters();
    perRegion.borders = BorderRule::paper;
    const SurfaceSnapshot surface = decimated(perRegion);
    for (std::size_t region = 0; region < surface.grid.regionCount(); ++region) {
        const VerticalError measured = measureVerticalError(m_zmap, surface.grid.points(region),
                                                            surface.triangles(region), GetParam().allowance);
        EXPECT_EQ(measured.beyond, 0U);
        EXPECT_NEAR(measured.largest, surface.meshes[region]->largestError, 1e-12);
    }
}

/// The negative control. The paper's accumulated error does not bound the vertical distance, and the check
/// above must be able to detect that.
TEST(Uncertified, isSeenToExceedTheAllowanceAtWalls) {
    const Heights heights = test::mapKind("walls").make(98, 66, 0.5, 17);
    const ZMapSnapshot zmap = test::zmapOf(98, 66, 0.5, heights);
    DecimationParameters parameters = test::leeParameters();
    parameters.certify = false;
    Surface surface(98, 66, parameters);
    surface.decimateDirty(zmap);
    const VerticalError error =
        measureVerticalError(zmap, {0, 0, 98, 66}, surface.snapshot().triangles(), parameters.allowance);
    EXPECT_GT(error.beyond, 0U);
    EXPECT_GT(error.largest, 3 * parameters.allowance);
}

/// The paper's borders cause cracks, which the topology check must detect.
TEST(PaperBorders, areSeenToCrack) {
    const Heights heights = test::mapKind("spheres").make(98, 66, 0.5, 17);
    DecimationParameters parameters = test::leeParameters();
    parameters.borders = BorderRule::paper;
    Surface surface(98, 66, parameters);
    surface.decimateDirty(test::zmapOf(98, 66, 0.5, heights));
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const LatticeTriangle& t : surface.snapshot().triangles())
        for (std::size_t k = 0; k < 3; ++k)
            edges.push_back({t[k], t[(k + 1) % 3]});
    std::sort(edges.begin(), edges.end());
    std::size_t open = 0;
    for (const auto& [a, b] : edges) {
        const auto onOutline = [](std::uint32_t v) {
            return v % 98 == 0 || v % 98 == 97 || v / 98 == 0 || v / 98 == 65;
        };
        const bool twin = std::binary_search(edges.begin(), edges.end(), std::array{b, a});
        open += twin || (onOutline(a) && onOutline(b)) ? 0 : 1;
    }
    EXPECT_GT(open, 0U);
}

TEST(LeeDecimator, dependsOnItsArgumentsOnly) {
    const Heights heights = test::mapKind("spheres").make(65, 65, 0.5, 2);
    const RegionGrid grid(65, 65, 64);
    const RegionSamples samples{grid.points(0), 0.5, 0.5, heights};
    LeeDecimator used;
    LeeDecimator fresh;
    const Heights other = test::mapKind("noise").make(81, 81, 0.5, 2);
    const RegionGrid otherGrid(81, 81, 80);
    (void)used.decimate(otherGrid, {otherGrid.points(0), 1, 1, other}, {}, 5, {});
    const RegionMesh a = used.decimate(grid, samples, {}, 9, {});
    const RegionMesh b = fresh.decimate(grid, samples, {}, 9, {});
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.largestError, b.largestError);
    EXPECT_NE(fresh.decimate(grid, samples, {}, 10, {}).triangles, a.triangles);
    DecimationParameters sequential;
    sequential.order = RemovalOrder::sequential;
    EXPECT_EQ(fresh.decimate(grid, samples, {}, 9, sequential).triangles,
              fresh.decimate(grid, samples, {}, 10, sequential).triangles);
}

TEST(LeeDecimator, givesNoMeshOnceStopped) {
    const Heights heights = test::mapKind("terrain").make(65, 65, 0.1, 2);
    const RegionGrid grid(65, 65, 64);
    const RegionSamples samples{grid.points(0), 0.1, 0.1, heights};
    std::stop_source source;
    source.request_stop();
    LeeDecimator decimator;
    EXPECT_TRUE(decimator.decimate(grid, samples, {}, 9, {}, source.get_token()).triangles.empty());
    // Its remaining data must not affect the next region.
    EXPECT_EQ(decimator.decimate(grid, samples, {}, 9, {}).triangles,
              LeeDecimator().decimate(grid, samples, {}, 9, {}).triangles);
}

/// Threads of its own, which use nothing of oneTBB.
TEST(LeeDecimator, ofOneThreadSharesNothingWithThatOfAnother) {
    const Heights heights = test::mapKind("spheres").make(65, 65, 0.5, 2);
    const ZMapSnapshot zmap = test::zmapOf(65, 65, 0.5, heights);
    const RegionGrid grid(65, 65, 16);
    DecimatorPool pool;
    std::array<std::vector<std::vector<LatticeTriangle>>, 4> meshes;
    {
        std::vector<std::jthread> threads;
        for (auto& own : meshes) {
            threads.emplace_back([&] {
                for (std::size_t region = 0; region < grid.regionCount(); ++region) {
                    DecimatorPool::Loan loan(pool, row(DecimationMethod::lee));
                    (*loan).heights.resize(17 * 17);
                    zmap.read(grid.points(region), (*loan).heights);
                    const RegionSamples samples{grid.points(region), 0.5, 0.5, (*loan).heights};
                    own.push_back((*loan).decimator->decimate(grid, samples, {}, region, {}).triangles);
                }
            });
        }
    }
    for (const auto& own : meshes)
        EXPECT_EQ(own, meshes.front());
}

TEST(LeeDecimator, withoutAllowanceGivesTheFullMesh) {
    const Heights heights(81, -1.0F);
    const RegionGrid grid(9, 9, 8);
    DecimationParameters exact;
    exact.allowance = 0;
    LeeDecimator decimator;
    const RegionMesh mesh = decimator.decimate(grid, {grid.points(0), 1, 1, heights}, {}, 1, exact);
    EXPECT_EQ(mesh.triangles.size(), 128U);
    EXPECT_EQ(mesh.largestError, 0);
}

TEST(LeeDecimator, acceptsFlatConstantAndExtremeHeights) {
    LeeDecimator decimator;
    const RegionGrid grid(17, 17, 16);
    for (const float extreme : {0.0F, -1e-30F, 1e6F, -1e20F, std::numeric_limits<float>::max()}) {
        for (const bool certify : {true, false}) {
            SCOPED_TRACE(std::to_string(extreme) + (certify ? " certified" : ""));
            DecimationParameters parameters = test::leeParameters();
            parameters.certify = certify;
            Heights heights(289, extreme);
            const auto check = [&] {
                const RegionMesh mesh =
                    decimator.decimate(grid, {grid.points(0), 1, 1, heights}, {}, 1, parameters);
                EXPECT_TRUE(std::isfinite(mesh.largestError));
                test::expectCoversMap(17, 17, mesh.triangles);
                if (certify) {
                    EXPECT_LE(test::bruteForceError(17, 17, heights, mesh.triangles), parameters.allowance);
                }
                return mesh;
            };
            const RegionMesh constant = check();
            if (std::abs(extreme) < 1e7F) {
                EXPECT_LT(constant.triangles.size(), 20U);
            }
            std::mt19937 random(3);
            for (float& height : heights)
                height = random() % 2 == 0 ? extreme : -extreme;
            check();
        }
    }
}

/// A map with a single row of cells, a single cell, and regions reduced to one cell.
TEST(LeeDecimator, acceptsRegionsOfOneCell) {
    for (const auto& [nx, ny, cells] :
         {std::array{2, 2, 8}, {2, 40, 8}, {40, 2, 8}, {10, 18, 8}, {18, 10, 8}, {5, 5, 3}, {9, 9, 2}}) {
        for (const auto& kind : test::mapKinds()) {
            SCOPED_TRACE(kind.name + " " + std::to_string(nx) + "x" + std::to_string(ny));
            const Heights heights = kind.make(nx, ny, 0.5, 23);
            for (const BorderRule borders : {BorderRule::shared, BorderRule::paper}) {
                DecimationParameters parameters = test::leeParameters();
                parameters.regionCells = cells;
                parameters.borders = borders;
                Surface surface(nx, ny, parameters);
                const ZMapSnapshot zmap = test::zmapOf(nx, ny, 0.5, heights);
                surface.decimateDirty(zmap);
                const auto triangles = surface.snapshot().triangles();
                EXPECT_EQ(triangles.size(), surface.faces());
                if (borders == BorderRule::shared)
                    test::expectCoversMap(nx, ny, triangles);
                EXPECT_EQ(measureVerticalError(zmap, {0, 0, nx, ny}, triangles, 0.05).beyond, 0U);
            }
        }
    }
}

TEST(DecimationMethods, haveOneRowEach) {
    ASSERT_EQ(decimationMethods().size(), kMethodChoices.size());
    for (std::size_t k = 0; k < decimationMethods().size(); ++k) {
        const DecimationMethodRow& method = decimationMethods()[k];
        EXPECT_EQ(static_cast<std::size_t>(method.method), k);
        EXPECT_EQ(row(method.method).method, method.method);
        EXPECT_EQ(method.create == nullptr, method.method == DecimationMethod::none);
    }
}

} // namespace
} // namespace proveout
