// SPDX-License-Identifier: GPL-3.0-or-later
// Wall points of maps whose walls follow a known outline: on the outline, and areas by closed formulas.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "core/zmap/wall_points.h"
#include "core/zmap/zmap.h"

namespace proveout {
namespace {

constexpr double kSize = 40;
constexpr float kDepth = -5;

/// A region in plan: the distance of a point from its outline, negative inside.
struct Region {
    std::string name;
    std::function<double(const Vec2&)> distance;
    double area;
    double onOutline;   ///< mm for a spacing of 1: what is allowed
    double areaAllowed; ///< mm², the same
    bool floorInside;   ///< a pocket, or else a boss
};

Vec2 gradient(const Region& region, const Vec2& at) {
    constexpr double kStep = 1e-6;
    const auto along = [&](const Vec2& way) {
        return (region.distance(at + way) - region.distance(at - way)) / (2 * kStep);
    };
    return glm::normalize(Vec2(along({kStep, 0}), along({0, kStep})));
}

double rectangle(const Vec2& at, const Vec2& half) {
    const Vec2 out = glm::abs(at) - half;
    return glm::length(glm::max(out, Vec2(0))) + std::min(std::max(out.x, out.y), 0.0);
}

Vec2 turned(const Vec2& at, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle) * at.x + std::sin(angle) * at.y, std::cos(angle) * at.y - std::sin(angle) * at.x};
}

const Vec2 kMiddle(kSize / 2 + 0.137, kSize / 2 - 0.211);

std::vector<Region> regions() {
    const auto circle = [](const Vec2& at) { return glm::length(at - kMiddle) - 10; };
    const auto slot = [](const Vec2& at) { return rectangle(turned(at - kMiddle, 17), {100, 4.3}); };
    const auto straight = [](const Vec2& at) { return rectangle(at - kMiddle, {8.4, 5.3}); };
    const auto aslant = [](const Vec2& at) { return rectangle(turned(at - kMiddle, 17), {8.4, 5.3}); };
    const auto diagonal = [](const Vec2& at) { return rectangle(turned(at - kMiddle, 45), {8.4, 5.3}); };
    const double circleArea = std::numbers::pi * 100;
    const double boxArea = 4 * 8.4 * 5.3;
    std::vector<Region> all;
    for (const bool pocket : {true, false}) {
        all.push_back({"circle", circle, circleArea, 2e-3, 0.7, pocket});
        all.push_back({"slot", slot, 0, 1e-4, 0, pocket});
        all.push_back({"rectangle", straight, boxArea, 1e-4, 0.1, pocket});
        all.push_back({"rectangle at 17 degrees", aslant, boxArea, 1e-4, 0.5, pocket});
        all.push_back({"rectangle at 45 degrees", diagonal, boxArea, 1e-4, 1.6, pocket});
    }
    return all;
}

/// The map of a region cut out of a box, or left of it, with its rims.
class Map {
public:
    Map(const Region& region, double spacing) : m_region(region) {
        const StockBox stock{{0, 0, 0}, kSize, kSize, 10};
        m_grid = makeGrid(stock, spacing).value();
        ZMap zmap(stock, m_grid);
        for (std::size_t tile = 0; tile < zmap.tileCount(); ++tile) {
            Tile& heights = zmap.tileForWriting(tile);
            const IndexRect rect = zmap.tileRect(tile);
            for (int j = rect.j0; j < rect.j1; ++j)
                for (int i = rect.i0; i < rect.i1; ++i)
                    heights.at(i - rect.i0, j - rect.j0) = isLow(place(i, j)) ? kDepth : 0;
        }
        m_moment = zmap.snapshot();
        RimMap rims;
        for (std::size_t tile = 0; tile < zmap.tileCount(); ++tile)
            rims.push_back(rimsOf(tile));
        m_moment.setRims(std::move(rims));
        m_moment.setWalls(WallPoints(m_moment));
    }

    [[nodiscard]] const ZMapSnapshot& moment() const { return m_moment; }
    [[nodiscard]] const Grid& grid() const { return m_grid; }
    [[nodiscard]] Vec2 place(int i, int j) const { return {m_grid.x(i), m_grid.y(j)}; }
    [[nodiscard]] bool isLow(const Vec2& at) const {
        return (m_region.distance(at) < 0) == m_region.floorInside;
    }
    [[nodiscard]] Vec3 vertex(int i, int j) const {
        const Vec2 at = place(i, j);
        const WallPoint* wall = m_moment.walls().find(i, j);
        if (wall == nullptr)
            return {at, m_moment.height(i, j)};
        return {at.x + wall->dx, at.y + wall->dy, wall->z};
    }
    [[nodiscard]] double fromOutline(const Vec3& vertex) const {
        return std::abs(m_region.distance(Vec2(vertex)));
    }

private:
    [[nodiscard]] RimTilePtr rimsOf(std::size_t tile) const {
        RimTile rims;
        const IndexRect rect = m_moment.tileRect(tile);
        for (int j = rect.j0; j < rect.j1; ++j) {
            for (int i = rect.i0; i < rect.i1; ++i) {
                for (const bool alongY : {false, true})
                    add(RimEdge{i - rect.i0, j - rect.j0, alongY}, i, j, rims);
            }
        }
        return rims.rims.empty() ? nullptr : std::make_shared<const RimTile>(std::move(rims));
    }
    void add(const RimEdge& edge, int i, int j, RimTile& rims) const {
        const int toI = i + (edge.alongY ? 0 : 1);
        const int toJ = j + (edge.alongY ? 1 : 0);
        if (toI >= m_grid.nx || toJ >= m_grid.ny || isLow(place(i, j)) == isLow(place(toI, toJ)))
            return;
        double from = 0;
        double to = 1;
        const auto at = [&](double way) { return glm::mix(place(i, j), place(toI, toJ), way); };
        for (int k = 0; k < 50; ++k) {
            const double middle = (from + to) / 2;
            (isLow(at(middle)) == isLow(at(0)) ? from : to) = middle;
        }
        const Vec2 normal = gradient(m_region, at(from)) * (m_region.floorInside ? 1.0 : -1.0);
        rims.rims.push_back({edge.index(), static_cast<std::uint16_t>(from * 65535), 0, kDepth,
                             static_cast<std::int16_t>(normal.x * 32767),
                             static_cast<std::int16_t>(normal.y * 32767)});
    }

    const Region& m_region;
    Grid m_grid;
    ZMapSnapshot m_moment;
};

double areaInPlan(const Vec3& a, const Vec3& b, const Vec3& c) {
    return ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2;
}

/// Where points cannot leave the border of the map.
bool isAtBorder(const Vec3& vertex, double spacing) {
    const Vec2 inside = glm::min(Vec2(vertex), Vec2(kSize) - Vec2(vertex));
    return std::min(inside.x, inside.y) < 1.5 * spacing;
}

/// Calls `work` with the vertices of each triangle of the canonical mesh.
template<class Work>
void forEachTriangle(const Map& map, const Work& work) {
    for (int j = 0; j + 1 < map.grid().ny; ++j) {
        for (int i = 0; i + 1 < map.grid().nx; ++i) {
            const auto at = [&](int di, int dj) { return map.vertex(i + di, j + dj); };
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
    for (const Region& region : regions()) {
        for (const double spacing : {1.0, 0.5, 0.23}) {
            SCOPED_TRACE(region.name + (region.floorInside ? ", pocket, at " : ", boss, at ") +
                         std::to_string(spacing));
            const Map map(region, spacing);
            ASSERT_GT(map.moment().walls().count(), 20U);
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
                    if (!isAtBorder(corner, spacing))
                        farthest = std::max(farthest, map.fromOutline(corner));
                }
            });
            EXPECT_LE(farthest, allowed) << "a vertex of a wall is beside the outline";
            EXPECT_GE(folded, -0.08 * spacing * spacing * spacing) << "a triangle is turned over";
            const double area = volume / static_cast<double>(kDepth);
            if (region.area > 0) {
                EXPECT_NEAR(region.floorInside ? area : kSize * kSize - area, region.area,
                            region.areaAllowed * spacing * spacing);
            }
        }
    }
}

} // namespace
} // namespace proveout
