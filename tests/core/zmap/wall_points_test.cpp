// SPDX-License-Identifier: GPL-3.0-or-later
// Wall points of maps whose walls follow a known outline: on the outline, and areas by closed formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/zmap/wall_points.h"
#include "tests/core/zmap/walled_map.h"

namespace proveout {
namespace {

double areaInPlan(const Vec3& a, const Vec3& b, const Vec3& c) {
    return ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2;
}

/// Calls `work` with the vertices of each triangle of the canonical mesh.
template<class Work>
void forEachTriangle(const WalledMap& map, const Work& work) {
    for (int j = 0; j + 1 < map.grid().ny; ++j) {
        for (int i = 0; i + 1 < map.grid().nx; ++i) {
            const auto at = [&](int di, int dj) { return vertexAt(map.moment(), i + di, j + dj); };
            if ((i + j) % 2 == 0) {
                work(std::array{at(0, 0), at(1, 0), at(1, 1)});
                work(std::array{at(0, 0), at(1, 1), at(0, 1)});
            } else {
                work(std::array{at(0, 0), at(1, 0), at(0, 1)});
                work(std::array{at(1, 0), at(1, 1), at(0, 1)});
            }
        }
    }
}

TEST(WallPoints, MakeWallsVerticalAndStandOnTheOutline) {
    for (const WalledRegion& region : walledRegions()) {
        for (const double spacing : {1.0, 0.5, 0.23}) {
            SCOPED_TRACE(region.name + (region.floorInside ? ", pocket, at " : ", boss, at ") +
                         std::to_string(spacing));
            const WalledMap map(region, spacing);
            ASSERT_GT(map.moment().walls().count(), 20U);
            EXPECT_EQ(map.moment().walls().find(0, 0), nullptr) << "far from any wall";
            const double allowed = region.onOutline * spacing;
            double volume = 0;
            double folded = 0;
            double farthest = 0;
            forEachTriangle(map, [&](const std::array<Vec3, 3>& corners) {
                const double area = areaInPlan(corners[0], corners[1], corners[2]);
                volume += area * (corners[0].z + corners[1].z + corners[2].z) / 3;
                if (corners[0].z == corners[1].z && corners[1].z == corners[2].z) {
                    folded = std::min(folded, area);
                    return;
                }
                for (const Vec3& corner : corners) {
                    if (!map.isAtBorder(corner))
                        farthest = std::max(farthest, map.fromOutline(corner));
                }
            });
            EXPECT_LE(farthest, allowed) << "a vertex of a wall is beside the outline";
            EXPECT_GE(folded, -0.08 * spacing * spacing * spacing) << "a triangle is turned over";
            const double area = volume / static_cast<double>(kWalledDepth);
            if (region.area > 0) {
                EXPECT_NEAR(region.floorInside ? area : kWalledSize * kWalledSize - area, region.area,
                            region.areaAllowed * spacing * spacing);
            }
        }
    }
}

/// Rectangles across tiles, beyond the map and without wall points.
TEST(WallPoints, OfARectangleCanBeRemoved) {
    const WalledMap map(walledRegions().front(), 0.23);
    const int nx = map.grid().nx;
    const int ny = map.grid().ny;
    const IndexRect all{0, 0, nx, ny};
    for (const IndexRect& rect :
         {IndexRect{50, 30, 90, 100}, IndexRect{-5, -5, nx + 5, 70}, IndexRect{0, 0, 9, 9}}) {
        WallPoints left = map.moment().walls();
        left.removeIn(rect);
        std::size_t count = 0;
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                const bool inside = i >= rect.i0 && i < rect.i1 && j >= rect.j0 && j < rect.j1;
                const bool is = map.moment().walls().find(i, j) != nullptr && !inside;
                EXPECT_EQ(left.find(i, j) != nullptr, is) << i << " " << j;
                count += is;
            }
        }
        EXPECT_EQ(left.count(), count);
        EXPECT_EQ(left.offsetsIn(all).size(), count);
    }
}

} // namespace
} // namespace proveout
