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
            DecimationParameters everyPoint;
            everyPoint.method = DecimationMethod::none;
            ZMapSnapshot moment = map.moment();
            const TriangleMesh full =
                closeWithWalls(moment, surface.triangles(), everyPoint, CoordinateType::float32)->mesh;
            expectWalls(map, region, full, 0);
            const TriangleMesh simple =
                closeWithWalls(moment, surface.triangles(), parameters, CoordinateType::float32)->mesh;
            EXPECT_EQ(moment.walls().count(), map.moment().walls().count());
            expectWalls(map, region, simple, kWallShare * parameters.allowance);
            EXPECT_LE(measureSolidError(map.moment(), simple, CoordinateType::float32, ErrorLevel::surface),
                      parameters.allowance);
            if (region.name != "circle") { // its chords are as long as the allowance lets them be already
                EXPECT_LE(4 * steepCount(simple), steepCount(full));
            }
        }
    }
}

/// Ribs and grooves thinner than cells, which the grid shows as noise, and a pocket far from them.
TEST(WallSurface, WallsThatTheGridDoesNotResolveLeaveOthersWhereTheyStand) {
    const Vec2 middle(13.3, 27.1);
    const auto distance = [&](const Vec2& at) {
        const double pocket = glm::length(at - middle) - 8;
        const double across = 0.98 * at.x + 0.199 * at.y - 27.7;
        const double groove = std::abs(across - 0.8 * std::round(across / 0.8)) - 0.17;
        const double grooves = std::max({groove, 24 - at.x, at.x - 37.5, 3 - at.y, at.y - 33});
        return std::min(pocket, grooves);
    };
    const WalledMap map({"pocket beside grooves", distance, 0, 0, 0, true}, 0.5);
    DecimationParameters parameters;
    parameters.allowance = 0.02;
    SurfaceSnapshot surface = decimatedWhole(map.moment(), parameters);
    ZMapSnapshot moment = map.moment();
    const auto solid = closeWithWalls(moment, surface.triangles(), parameters, CoordinateType::float32);
    ASSERT_TRUE(solid.has_value());
    EXPECT_EQ(whatIsWrong(solid->mesh), "");
    EXPECT_LT(moment.walls().count(), map.moment().walls().count());
    EXPECT_LE(measureSolidError(moment, solid->mesh, CoordinateType::float32, ErrorLevel::surface),
              parameters.allowance);
    std::size_t ofPocket = 0;
    forEachSteep(solid->mesh, [&](const std::array<Vec3, 3>& corners) {
        if (corners[0].x > 23 || map.isAtBorder(corners[0]))
            return;
        ++ofPocket;
        for (const Vec3& corner : corners)
            EXPECT_NEAR(glm::length(Vec2(corner) - middle), 8, 3e-3);
    });
    EXPECT_GT(ofPocket, 60U);
}

/// Openings and parts that are cut out, some of them across the border of the stock.
TEST(WallSurface, PartsThatAreCutThroughHaveTheirWalls) {
    for (const WalledRegion& region : walledRegions()) {
        for (const double spacing : {1.0, 0.37}) {
            SCOPED_TRACE(region.name + (region.floorInside ? ", opening, at " : ", part, at ") +
                         std::to_string(spacing));
            const WalledMap map(region, spacing, -static_cast<double>(kWalledDepth));
            DecimationParameters parameters;
            parameters.allowance = 0.02;
            ZMapSnapshot moment = map.moment();
            SurfaceSnapshot surface = decimatedWhole(moment, parameters);
            const auto solid =
                closeWithWalls(moment, surface.triangles(), parameters, CoordinateType::float32);
            ASSERT_TRUE(solid.has_value());
            EXPECT_EQ(whatIsWrong(solid->mesh), "");
            EXPECT_EQ(moment.walls().count(), map.moment().walls().count());
            if (region.area > 0) {
                const double left =
                    region.floorInside ? kWalledSize * kWalledSize - region.area : region.area;
                EXPECT_NEAR(signedVolume(solid->mesh) / -static_cast<double>(kWalledDepth), left,
                            region.areaAllowed * spacing * spacing +
                                0.02 * parameters.allowance * region.area);
            }
        }
    }
}

} // namespace
} // namespace proveout::test
