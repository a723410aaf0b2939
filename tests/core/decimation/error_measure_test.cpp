// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/error_measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/decimation/topology.h"

namespace proveout {
namespace {

TEST(VerticalError, ofTheFullMeshIsZero) {
    const test::Heights heights = test::mapKind("noise").make(70, 66, 1, 1);
    const ZMapSnapshot zmap = test::zmapOf(70, 66, 1, heights);
    const RegionGrid grid(70, 66, 100);
    const VerticalError error = measureVerticalError(zmap, {0, 0, 70, 66}, fullRegionMesh(grid, 0), 0);
    EXPECT_EQ(error.largest, 0);
    EXPECT_EQ(error.beyond, 0U);
    EXPECT_EQ(error.uncovered, 0U);
}

TEST(VerticalError, isThatOfASinglePeak) {
    test::Heights heights(25, -3.0F);
    heights[12] = -1.0F;
    const ZMapSnapshot zmap = test::zmapOf(5, 5, 1, heights);
    const std::vector<LatticeTriangle> twoTriangles{{0, 4, 24}, {0, 24, 20}};
    const VerticalError error = measureVerticalError(zmap, {0, 0, 5, 5}, twoTriangles, 0.5);
    EXPECT_DOUBLE_EQ(error.largest, 2);
    EXPECT_EQ(error.beyond, 1U);
    EXPECT_EQ(error.uncovered, 0U);
}

TEST(VerticalError, countsWhatIsNotCoveredAndIsThenInfinite) {
    const ZMapSnapshot zmap = test::zmapOf(5, 5, 1, test::Heights(25, -3.0F));
    const std::vector<LatticeTriangle> half{{0, 4, 24}};
    const VerticalError error = measureVerticalError(zmap, {0, 0, 5, 5}, half, 0.5);
    EXPECT_TRUE(std::isinf(error.largest));
    EXPECT_EQ(error.uncovered, 10U);
    EXPECT_EQ(error.beyond, 10U);
    // Only the points of the rectangle count.
    EXPECT_EQ(measureVerticalError(zmap, {2, 0, 5, 3}, half, 0.5).uncovered, 0U);
    EXPECT_EQ(measureVerticalError(zmap, {}, half, 0.5).largest, 0);
}

TEST(VerticalError, takesTheLargerDistanceOnASharedEdge) {
    // Two sheets over the same points: the lower one is 1 mm off in the middle.
    test::Heights heights(9, -1.0F);
    heights[4] = -2.0F;
    const ZMapSnapshot zmap = test::zmapOf(3, 3, 1, heights);
    const std::vector<LatticeTriangle> sheets{{0, 2, 4}, {2, 8, 4}, {8, 6, 4},
                                              {6, 0, 4}, {0, 2, 8}, {0, 8, 6}};
    EXPECT_DOUBLE_EQ(measureVerticalError(zmap, {0, 0, 3, 3}, sheets, 0.5).largest, 1);
}

TEST(VerticalError, agreesWithBruteForceOnRandomTriangles) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const int n = 3 + static_cast<int>(random() % (seed % 20 == 0 ? 120 : 30)); // also several bands
        const test::Heights heights = test::mapKind("noise").make(n, n, 1, seed);
        const ZMapSnapshot zmap = test::zmapOf(n, n, 1, heights);
        // A fan around the outline covers the map wherever its apex is.
        const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * n + i); };
        const std::uint32_t apex = at(1 + static_cast<int>(random() % static_cast<unsigned>(n - 2)),
                                      1 + static_cast<int>(random() % static_cast<unsigned>(n - 2)));
        std::vector<LatticeTriangle> fan;
        for (int k = 0; k + 1 < n; ++k) {
            fan.push_back({at(k, 0), at(k + 1, 0), apex});
            fan.push_back({at(n - 1, k), at(n - 1, k + 1), apex});
            fan.push_back({at(k + 1, n - 1), at(k, n - 1), apex});
            fan.push_back({at(0, k + 1), at(0, k), apex});
        }
        const VerticalError error = measureVerticalError(zmap, {0, 0, n, n}, fan, 0.05);
        EXPECT_NEAR(error.largest, test::bruteForceError(n, n, heights, fan), 1e-12);
        EXPECT_EQ(error.uncovered, 0U);
    }
}

} // namespace
} // namespace proveout
