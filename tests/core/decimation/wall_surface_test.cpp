// SPDX-License-Identifier: GPL-3.0-or-later
// Decimated surfaces and solids of maps with walls: walls stand on their outline, and solids are closed and
// have the volume of their shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/decimation/solid/solid.h"
#include "core/decimation/surface/refined_surface.h"
#include "tests/core/decimation/closed_mesh.h"
#include "tests/core/zmap/walled_map.h"

namespace proveout::test {
namespace {

constexpr double kStockHeight = 10;

/// How far the vertices of steep triangles are beside the outline at most.
double farthestOfWalls(const WalledMap& map, const TriangleMesh& solid) {
    double farthest = 0;
    for (const auto& triangle : solid.triangles) {
        const Vec3 a = solid.vertices[triangle[0]];
        const Vec3 b = solid.vertices[triangle[1]];
        const Vec3 c = solid.vertices[triangle[2]];
        const Vec3 normal = glm::cross(b - a, c - a);
        if (std::abs(normal.z) > 0.1 * glm::length(normal))
            continue;
        for (const Vec3& corner : {a, b, c}) {
            if (!map.isAtBorder(corner))
                farthest = std::max(farthest, map.fromOutline(corner));
        }
    }
    return farthest;
}

TEST(WallSurface, DecimatedSolidsHaveWallsOnTheirOutlineAndTheirVolume) {
    for (const WalledRegion& region : walledRegions()) {
        for (const double spacing : {1.0, 0.37}) {
            SCOPED_TRACE(region.name + (region.floorInside ? ", pocket, at " : ", boss, at ") +
                         std::to_string(spacing));
            const WalledMap map(region, spacing);
            DecimationParameters parameters;
            parameters.allowance = 0.02;
            SurfaceSnapshot surface = decimatedWhole(map.moment(), parameters);
            std::set<std::uint32_t> vertices;
            for (const LatticeTriangle& triangle : surface.triangles())
                vertices.insert(triangle.begin(), triangle.end());
            const auto nx = static_cast<std::uint32_t>(map.grid().nx);
            const IndexRect all{0, 0, map.grid().nx, map.grid().ny};
            for (const std::uint32_t wall : map.moment().walls().offsetsIn(all))
                EXPECT_TRUE(vertices.contains(wall)) << wall % nx << " " << wall / nx;
            const TriangleMesh solid = closeSolid(map.moment(), surface.releaseTriangles());
            EXPECT_EQ(whatIsWrong(solid), "");
            EXPECT_LE(farthestOfWalls(map, solid), region.onOutline * spacing);
            if (region.area > 0) {
                const double cut = region.floorInside ? region.area : kWalledSize * kWalledSize - region.area;
                const double depth = -static_cast<double>(kWalledDepth);
                EXPECT_NEAR(signedVolume(solid), kWalledSize * kWalledSize * kStockHeight - cut * depth,
                            region.areaAllowed * spacing * spacing * depth);
            }
        }
    }
}

} // namespace
} // namespace proveout::test
