// SPDX-License-Identifier: GPL-3.0-or-later
// Rims of stock that is a mesh, compared with the lines in plan of its upright walls.
#include "core/cutting/cut/tile_rims.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vector>

#include "core/cutter/shapes.h"
#include "core/cutting/cut/cutting.h"
#include "core/zmap/mesh_stock.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/core/zmap/mesh_bodies.h"

namespace proveout {
namespace {

using Corners = std::vector<Vec2>;

/// The nearest point of a closed polygon, and its distance.
struct OnSide {
    Vec2 at{0};
    double distance = 1e30;
    Vec2 inwards{0}; ///< the polygon is counter-clockwise
};

OnSide nearestOn(const Corners& corners, const Vec2& place) {
    OnSide nearest;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 from = corners[k];
        const Vec2 side = corners[(k + 1) % corners.size()] - from;
        const double t = std::clamp(glm::dot(place - from, side) / glm::dot(side, side), 0.0, 1.0);
        const Vec2 at = from + t * side;
        if (const double distance = glm::distance(at, place); distance < nearest.distance)
            nearest = {at, distance, glm::normalize(Vec2(-side.y, side.x))};
    }
    return nearest;
}

bool isInside(const Corners& corners, const Vec2& place) {
    bool inside = false;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 a = corners[k];
        const Vec2 b = corners[(k + 1) % corners.size()];
        if ((a.y > place.y) != (b.y > place.y) && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

/// The edges between a point inside and one outside; points on the polygon are inside.
std::size_t edgesAcross(const Corners& corners, const Grid& grid) {
    const auto inside = [&](int i, int j) {
        const Vec2 place(grid.x(i), grid.y(j));
        return isInside(corners, place) || nearestOn(corners, place).distance < 1e-6;
    };
    std::size_t count = 0;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            count += i + 1 < grid.nx && inside(i, j) != inside(i + 1, j) ? 1 : 0;
            count += j + 1 < grid.ny && inside(i, j) != inside(i, j + 1) ? 1 : 0;
        }
    return count;
}

struct MeshMap {
    std::shared_ptr<const StockBody> body;
    StockBox stock;
    std::vector<CutterMotion> motions;
    ZMapSnapshot map;

    MeshMap(StockMesh mesh, double spacing, double wider, std::vector<CutterMotion> all = {})
        : body(meshStock(std::move(mesh)).value()), stock(body->box()), motions(std::move(all)) {
        Grid grid = makeGrid(stock, spacing).value();
        // The walls that touch the sides of the box are at points: other grids have them between points.
        grid.x0 -= wider;
        grid.y0 -= wider;
        grid.nx += 2;
        grid.ny += 2;
        ZMap zmap = body->uncut(stock, grid).zmap;
        EXPECT_TRUE(cutHeights(zmap, motions, {}));
        map = zmap.snapshot();
    }
    /// Calls `look` with each rim and its place.
    template<class Look>
    std::size_t eachRim(const Look& look) const {
        const auto top = body->top(stock);
        const Grid& grid = map.grid();
        std::size_t count = 0;
        for (std::size_t tile = 0; tile < map.tileCount(); ++tile) {
            const RimTilePtr rims = rimsOfTile(map, tile, top.get(), motions, {}, RimEdges::atLevels);
            const IndexRect rect = map.tileRect(tile);
            for (const Rim& rim : rims == nullptr ? std::vector<Rim>() : rims->rims) {
                const RimEdge edge = RimEdge::of(rim.edge);
                const double along = rim.fraction(true);
                look(rim, Vec2(grid.x(rect.i0 + edge.i) + (edge.alongY ? 0 : along * grid.hx),
                               grid.y(rect.j0 + edge.j) + (edge.alongY ? along * grid.hy : 0)));
                ++count;
            }
        }
        return count;
    }
    [[nodiscard]] double tolerance() const {
        return 2.0 / 65536 * std::max(map.grid().hx, map.grid().hy) + 1e-6;
    }
};

/// `touching`: how many rims are beside points that touch a round wall, where it has no direction.
void expectWallsOn(const Corners& corners, const MeshMap& made, int touching = 0) {
    double largest = 0;
    int turned = 0;
    const std::size_t rims = made.eachRim([&](const Rim& rim, const Vec2& at) {
        const OnSide side = nearestOn(corners, at);
        largest = std::max(largest, side.distance);
        turned += glm::distance(rim.normal(), side.inwards) > 0.01 ? 1 : 0;
        EXPECT_TRUE(rim.isUpright());
        EXPECT_EQ(rim.top, 0.0F);
        EXPECT_EQ(rim.bottom, made.map.floor());
    });
    EXPECT_EQ(rims, edgesAcross(corners, made.map.grid()));
    EXPECT_LE(largest, made.tolerance());
    EXPECT_EQ(turned, touching);
    testing::Test::RecordProperty("largest", fmt::format("{:.2e}", largest));
}

TEST(MeshRims, OfARoundMeshAreOnItsSides) {
    for (const double spacing : {0.5, 1.0})
        for (const double wider : {0.13, 0.0}) {
            const StockMesh mesh = roundBody(15, 10, 720);
            Corners corners;
            for (std::size_t k = 2; k < mesh.vertices.size(); k += 2)
                corners.emplace_back(mesh.vertices[k]);
            expectWallsOn(corners, MeshMap(mesh, spacing, wider), wider == 0 ? 8 : 0);
        }
}

TEST(MeshRims, OfATurnedBoxAreOnItsSides) {
    for (const double spacing : {0.5, 1.0})
        for (const double degrees : {17.0, 0.0, 45.0}) {
            StockMesh mesh;
            addBox(mesh, {-20, -12, -10}, {20, 12, 0});
            turn(mesh, degrees);
            const Corners corners{mesh.vertices[4], mesh.vertices[5], mesh.vertices[7], mesh.vertices[6]};
            expectWallsOn(corners, MeshMap(mesh, spacing, 0.13));
        }
}

TEST(MeshRims, OfASlotThroughATurnedBoxAreOnBoth) {
    StockMesh mesh;
    addBox(mesh, {-20, -12, -10}, {20, 12, 0});
    turn(mesh, 17);
    const Corners corners{mesh.vertices[4], mesh.vertices[5], mesh.vertices[7], mesh.vertices[6]};
    const Cutter mill = cutterOf("flat:d=8");
    const MeshMap made(mesh, 0.5, 0.13, {{&mill, straightMotion({-30, 0.1, -3}, {30, 0.1, -3})}});
    int onSlot = 0;
    made.eachRim([&](const Rim& rim, const Vec2& at) {
        const double toSide = nearestOn(corners, at).distance;
        const double toSlot = std::abs(std::abs(at.y - 0.1) - 4);
        EXPECT_LE(std::min(toSide, toSlot), made.tolerance());
        onSlot += toSlot < toSide ? 1 : 0;
        const bool isBeside = std::abs(at.y - 0.1) > 4 - 1e-5;
        EXPECT_NEAR(rim.top, isBeside ? 0 : -3, 1e-6);
    });
    EXPECT_GT(onSlot, 100);
}

} // namespace
} // namespace proveout
