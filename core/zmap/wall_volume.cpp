// SPDX-License-Identifier: GPL-3.0-or-later
// The canonical surface with the vertices beside walls moved to the walls is a graph over the same area, but
// for walls that are upright. So its volume is the sum over its triangles of their areas in plan, which are
// negative where it is folded, times their mean heights, and only cells with such vertices differ from those
// of the grid.
#include "core/zmap/wall_volume.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/base/parallel.h"
#include "core/zmap/wall_points.h"

namespace proveout {

namespace {

struct WallVertex {
    Vec3 at;     ///< relative to the top of the stock
    Vec2 normal; ///< of the wall; 0: none
};

/// The points beside walls in and around a tile.
class TileWalls {
public:
    TileWalls(const ZMapSnapshot& zmap, std::size_t tile) : m_zmap(zmap), m_tile(zmap.tileRect(tile)) {
        const Grid& grid = zmap.grid();
        const IndexRect known = intersection({m_tile.i0 - 2, m_tile.j0 - 2, m_tile.i1 + 3, m_tile.j1 + 3},
                                             {0, 0, grid.nx, grid.ny});
        for (const std::uint32_t offset : zmap.walls().offsetsIn(known)) {
            if (m_points.empty())
                m_points.resize(std::size_t{kSide} * kSide);
            const int i = known.i0 + static_cast<int>(offset) % known.width();
            const int j = known.j0 + static_cast<int>(offset) / known.width();
            m_points[placeOf(i, j)] = zmap.walls().find(i, j);
        }
    }

    [[nodiscard]] bool empty() const { return m_points.empty(); }
    [[nodiscard]] const IndexRect& rect() const { return m_tile; }
    [[nodiscard]] const ZMapSnapshot& zmap() const { return m_zmap; }

    /// The upright wall that a point of the tile, or the next one, is on. Null beside the slope below a
    /// crease: what a ball leaves there is round between its points, and the sum of heights is nearer to it.
    /// The points on both sides of a wall then are: on one side alone, its volume would be that of a slope.
    /// Null if the wall is along a border that the points on its other side cannot leave.
    [[nodiscard]] const WallPoint* wallAt(int i, int j) const {
        const WallPoint* wall = m_points[placeOf(i, j)];
        if (wall == nullptr || !wall->isUpright || isAlongBorder(*wall, i, j))
            return nullptr;
        for (int y = j - 1; y <= j + 1; ++y) {
            for (int x = i - 1; x <= i + 1; ++x) {
                const WallPoint* near = m_points[placeOf(x, y)];
                if (near != nullptr && near->isUpright && isNearSlope(x, y))
                    return nullptr;
            }
        }
        return wall;
    }

private:
    static constexpr int kSide = Tile::kSize + 5; ///< with two points before the tile, and three after it

    [[nodiscard]] bool isAlongBorder(const WallPoint& wall, int i, int j) const {
        const Grid& grid = m_zmap.grid();
        // From the next point to the border, a wall is shared with a point of the border only if it is there.
        const bool besideX =
            i == 0 || i == grid.nx - 1 || (i == 1 && wall.dx < 0) || (i == grid.nx - 2 && wall.dx > 0);
        const bool besideY =
            j == 0 || j == grid.ny - 1 || (j == 1 && wall.dy < 0) || (j == grid.ny - 2 && wall.dy > 0);
        return (besideX && 2 * std::abs(wall.normalX) >= std::abs(wall.normalY)) ||
               (besideY && 2 * std::abs(wall.normalY) >= std::abs(wall.normalX));
    }
    [[nodiscard]] bool isNearSlope(int i, int j) const {
        for (int y = j - 1; y <= j + 1; ++y)
            for (int x = i - 1; x <= i + 1; ++x)
                if (const WallPoint* near = m_points[placeOf(x, y)]; near != nullptr && !near->isUpright)
                    return true;
        return false;
    }
    [[nodiscard]] std::size_t placeOf(int i, int j) const {
        return static_cast<std::size_t>(j - m_tile.j0 + 2) * kSide +
               static_cast<std::size_t>(i - m_tile.i0 + 2);
    }

    const ZMapSnapshot& m_zmap;
    IndexRect m_tile;
    std::vector<const WallPoint*> m_points; ///< row by row; empty: none
};

WallVertex vertexOf(const TileWalls& walls, int i, int j) {
    const Grid& grid = walls.zmap().grid();
    const WallPoint* wall = walls.wallAt(i, j);
    if (wall == nullptr)
        return {{grid.x(i), grid.y(j), static_cast<double>(walls.zmap().height(i, j))}, Vec2(0)};
    const auto value = [](auto number) { return static_cast<double>(number); };
    const Vec2 normal(value(wall->normalX), value(wall->normalY));
    return {{grid.x(i) + value(wall->dx), grid.y(j) + value(wall->dy), value(wall->z)},
            normal == Vec2(0) ? normal : glm::normalize(normal)};
}

/// Between a face of a wall and the wall, which is round: two thirds of its sagitta times its area.
double besideFace(const WallVertex& a, const WallVertex& b, double area) {
    constexpr double kSameWall = 0.5; // as a cosine
    const double length = glm::distance(Vec2(a.at), Vec2(b.at));
    if (!(length > 0) || !(glm::dot(a.normal, b.normal) > kSameWall))
        return 0;
    const Vec2 along = (Vec2(b.at) - Vec2(a.at)) / length;
    return area * length * glm::dot(a.normal - b.normal, along) / 12;
}

double under(const WallVertex& a, const WallVertex& b, const WallVertex& c) {
    const Vec3 normal = glm::cross(b.at - a.at, c.at - a.at);
    double volume = normal.z / 2 * (a.at.z + b.at.z + c.at.z) / 3;
    const double upright = glm::length(Vec2(normal)) / 2;
    if (upright > std::abs(normal.z) / 2) {
        const std::array<double, 3> lengths{glm::distance(Vec2(a.at), Vec2(b.at)),
                                            glm::distance(Vec2(b.at), Vec2(c.at)),
                                            glm::distance(Vec2(c.at), Vec2(a.at))};
        const auto longest = std::ranges::max_element(lengths) - lengths.begin();
        const std::array<const WallVertex*, 4> corners{&a, &b, &c, &a};
        volume += besideFace(*corners[static_cast<std::size_t>(longest)],
                             *corners[static_cast<std::size_t>(longest) + 1], upright);
    }
    return volume;
}

/// With walls, less that of the grid.
double ofCell(const TileWalls& walls, int i, int j) {
    const std::array<WallVertex, 4> at{vertexOf(walls, i, j), vertexOf(walls, i + 1, j),
                                       vertexOf(walls, i + 1, j + 1), vertexOf(walls, i, j + 1)};
    const auto& [a, b, c, d] = at;
    const double walled =
        (i + j) % 2 == 0 ? under(a, b, c) + under(a, c, d) : under(a, b, d) + under(b, c, d);
    const ZMapSnapshot& zmap = walls.zmap();
    const double sum = static_cast<double>(zmap.height(i, j)) + static_cast<double>(zmap.height(i + 1, j)) +
                       static_cast<double>(zmap.height(i + 1, j + 1)) +
                       static_cast<double>(zmap.height(i, j + 1));
    return walled - sum / 4 * zmap.grid().hx * zmap.grid().hy;
}

/// Of the cells whose points with the least coordinates are in a tile.
double ofTile(const ZMapSnapshot& zmap, std::size_t tile) {
    const TileWalls walls(zmap, tile);
    if (walls.empty())
        return 0;
    const IndexRect& rect = walls.rect();
    const int endI = std::min(rect.i1, zmap.grid().nx - 1);
    const int endJ = std::min(rect.j1, zmap.grid().ny - 1);
    const auto isWalled = [&](int i, int j) { return walls.wallAt(i, j) != nullptr; };
    double volume = 0;
    for (int j = rect.j0; j < endJ; ++j)
        for (int i = rect.i0; i < endI; ++i)
            if (isWalled(i, j) || isWalled(i + 1, j) || isWalled(i, j + 1) || isWalled(i + 1, j + 1))
                volume += ofCell(walls, i, j);
    return volume;
}

} // namespace

double volumeAtWalls(const ZMapSnapshot& zmap) {
    if (zmap.walls().empty())
        return 0;
    std::vector<double> ofTiles(zmap.tileCount());
    inParallel(ofTiles.size(), [&](std::size_t tile) { ofTiles[tile] = ofTile(zmap, tile); });
    double volume = 0;
    for (const double one : ofTiles) // in order: the same sum whatever the threads
        volume += one;
    return volume;
}

} // namespace proveout
