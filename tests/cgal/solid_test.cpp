// SPDX-License-Identifier: GPL-3.0-or-later
// Solids of stock that touches its floor, checked by CGAL.
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "core/decimation/solid/solid.h"
#include "core/decimation/surface/surface.h"
#include "tests/cgal/solid_oracle.h"
#include "tests/core/decimation/closed_mesh.h"
#include "tests/core/decimation/maps.h"
#include "tests/core/decimation/random_triangulation.h"
#include "tests/random_seed.h"

namespace proveout::test {
namespace {

constexpr float kFloor = -100; // as in zmapOf()

Heights randomHeights(int points, std::mt19937& random) {
    const unsigned percents[] = {0, 10, 40, 70};
    const unsigned percent = percents[random() % 4];
    Heights heights;
    for (int v = 0; v < points; ++v)
        heights.push_back(random() % 100 < percent ? kFloor
                                                   : kFloor * static_cast<float>(random() % 1000) / 1000);
    return heights;
}

TEST(SolidOnFloor, BoundsAVolumeWithoutIntersections) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    int closed = 0;
    for (int round = 0; round < 400; ++round) {
        SCOPED_TRACE(round);
        const int nx = 2 + static_cast<int>(random() % 14);
        const int ny = 2 + static_cast<int>(random() % 14);
        const double spacing = 0.1 * (1 + static_cast<double>(random() % 20));
        const ZMapSnapshot zmap = zmapOf(nx, ny, spacing, randomHeights(nx * ny, random));
        const TriangleMesh solid = closeSolid(zmap, randomTriangulation(nx, ny, random() % 300, random));
        if (solid.triangles.empty())
            continue;
        ASSERT_EQ(whatCgalFindsWrong(solid, Intersections::look), "");
        ++closed;
    }
    EXPECT_GT(closed, 300);
}

/// Decimated maps that are cut through in places, like the surfaces of real exports.
TEST(SolidOnFloor, DecimatedSurfacesThatAreCutThroughBoundAVolume) {
    for (const char* name : {"terrain", "walls", "spheres", "noise"}) {
        constexpr int kNx = 61;
        constexpr int kNy = 47;
        Heights heights = mapKind(name).make(kNx, kNy, 1.0, 7);
        const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
        const float through = *low + (*high - *low) / 3; // everything lower is cut through
        for (float& height : heights)
            height = std::max(kFloor, height <= through ? kFloor : height);
        const ZMapSnapshot zmap = zmapOf(kNx, kNy, 1.0, heights);
        for (const int region : {5, 8, 64}) {
            SCOPED_TRACE(testing::Message() << name << ", region " << region);
            DecimationParameters parameters;
            parameters.regionCells = region;
            Surface surface(kNx, kNy, parameters);
            surface.decimateDirty(zmap);
            const auto triangles = surface.snapshot().triangles();
            const TriangleMesh solid = closeSolid(zmap, triangles);
            ASSERT_FALSE(solid.triangles.empty());
            EXPECT_LT(solid.triangles.size(), 4 * triangles.size());
            EXPECT_EQ(whatIsWrong(solid), "");
            EXPECT_EQ(whatCgalFindsWrong(solid, Intersections::look), "");
        }
    }
}

TriangleMesh box() {
    const ZMapSnapshot zmap = zmapOf(5, 5, 1, Heights(25, -1));
    return closeSolid(zmap, fullTriangulation(5, 5));
}

TEST(SolidOracle, SeesWhatIsWrong) {
    EXPECT_EQ(whatCgalFindsWrong(box(), Intersections::look), "");

    auto hole = box();
    hole.triangles.pop_back();
    EXPECT_EQ(whatCgalFindsWrong(hole, Intersections::look), "not closed");

    auto turned = box();
    std::swap(turned.triangles.front()[0], turned.triangles.front()[1]);
    EXPECT_EQ(whatCgalFindsWrong(turned, Intersections::look), "no polygon mesh");

    auto insideOut = box();
    for (auto& triangle : insideOut.triangles)
        std::swap(triangle[0], triangle[1]);
    EXPECT_EQ(whatCgalFindsWrong(insideOut, Intersections::look), "normals inwards");

    auto pierced = box();
    pierced.vertices[12].z = -200; // moves a vertex of the top below the floor
    EXPECT_NE(whatCgalFindsWrong(pierced, Intersections::look), "");
}

} // namespace
} // namespace proveout::test
