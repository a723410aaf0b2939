// SPDX-License-Identifier: GPL-3.0-or-later
// Decimated surfaces and solids of maps with walls: walls stand on their outline, and solids are closed and
// have the volume of their shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "core/decimation/solid/solid.h"
#include "core/decimation/solid/solid_error.h"
#include "core/decimation/solid/wall_simplifier.h"
#include "core/decimation/surface/refined_surface.h"
#include "tests/core/decimation/closed_mesh.h"
#include "tests/core/zmap/walled_map.h"

namespace proveout::test {
namespace {

constexpr double kStockHeight = 10;

/// Calls `work` with the corners of the triangles of walls.
template<class Work>
void forEachSteep(const TriangleMesh& solid, const Work& work) {
    for (const auto& triangle : solid.triangles) {
        const std::array corners{solid.vertices[triangle[0]], solid.vertices[triangle[1]],
                                 solid.vertices[triangle[2]]};
        const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (std::abs(normal.z) <= 0.1 * glm::length(normal))
            work(corners);
    }
}

std::size_t steepCount(const TriangleMesh& solid) {
    std::size_t count = 0;
    forEachSteep(solid, [&](const auto&) { ++count; });
    return count;
}

/// `beside`: how far walls may be beside points that they do not have any more.
void expectWalls(const WalledMap& map, const WalledRegion& region, const TriangleMesh& solid, double beside) {
    EXPECT_EQ(whatIsWrong(solid), "");
    const double spacing = map.grid().hx;
    double farthest = 0;
    forEachSteep(solid, [&](const std::array<Vec3, 3>& corners) {
        for (const Vec3& corner : corners) {
            if (!map.isAtBorder(corner))
                farthest = std::max(farthest, map.fromOutline(corner));
        }
    });
    EXPECT_LE(farthest, region.onOutline * spacing);
    if (region.area > 0) {
        constexpr double kLongestOutline = 65;
        const double cut = region.floorInside ? region.area : kWalledSize * kWalledSize - region.area;
        const double depth = -static_cast<double>(kWalledDepth);
        EXPECT_NEAR(signedVolume(solid), kWalledSize * kWalledSize * kStockHeight - cut * depth,
                    (region.areaAllowed * spacing * spacing + beside * kLongestOutline) * depth);
    }
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
            const TriangleMesh full = *closeWithWalls(map.moment(), surface.triangles(), 0);
            expectWalls(map, region, full, 0);
            const TriangleMesh simple =
                *closeWithWalls(map.moment(), surface.triangles(), parameters.allowance);
            expectWalls(map, region, simple, kWallShare * parameters.allowance);
            EXPECT_LE(measureSolidError(map.moment(), simple, CoordinateType::float32, ErrorLevel::sample),
                      parameters.allowance);
            if (region.name != "circle") { // its chords are as long as the allowance lets them be already
                EXPECT_LE(4 * steepCount(simple), steepCount(full));
            }
        }
    }
}

} // namespace
} // namespace proveout::test
