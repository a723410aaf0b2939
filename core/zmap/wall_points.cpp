// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/wall_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/parallel.h"
#include "core/zmap/cell_walls.h"
#include "core/zmap/zmap.h"

namespace proveout {

namespace {

constexpr std::array<GridStep, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// The walls of the cells of a tile, and of two around it, made when a point first asks: a cell has four.
class CellsOfTile {
public:
    explicit CellsOfTile(const RimSurroundings& around) : m_around(around) {}

    /// Null unless two walls cross the edges of a cell on this side.
    [[nodiscard]] const CellWalls* twoWalls(int i, int j, bool high) {
        if (std::popcount(m_around.edgesOf(i, j, high)) != 2)
            return nullptr;
        const auto x = static_cast<std::size_t>(i - m_around.rect().i0 + 2);
        const auto y = static_cast<std::size_t>(j - m_around.rect().j0 + 2);
        std::uint16_t& known = m_known.at((y * kSide + x) * 2 + (high ? 1 : 0));
        if (known == 0) {
            m_cells.emplace_back(m_around, i, j, high);
            known = static_cast<std::uint16_t>(m_cells.size());
        }
        return &m_cells[known - 1U];
    }

private:
    static constexpr std::size_t kSide = Tile::kSize + 3;

    const RimSurroundings& m_around;
    std::vector<CellWalls> m_cells;
    std::array<std::uint16_t, 2 * kSide * kSide> m_known{}; ///< by cell and side: its place, from 1 on
};

/// One point of a tile.
class PointPlace {
public:
    PointPlace(const RimSurroundings& around, CellsOfTile& cells, int i, int j)
        : m_around(around), m_cells(cells), m_i(i), m_j(j) {
        const Grid& grid = around.grid();
        m_freeX = i > 0 && i < grid.nx - 1;
        m_freeY = j > 0 && j < grid.ny - 1;
        for (const GridStep& step : kSteps)
            if (step.di != 0 ? m_freeX : m_freeY)
                look(step);
        m_isFree = m_freeX && m_freeY;
        if (m_isFree || m_count > 0 || !isOutsideStock())
            return;
        m_isFree = true;
        for (const GridStep& step : kSteps)
            look(step);
    }

    [[nodiscard]] std::optional<WallPlace> place() const {
        if (m_mixed)
            return stays();
        if (m_isFree) {
            if (const auto sharp = ofCells(&CellWalls::sharp))
                return sharp;
            const auto opposite = m_count == 0 ? ofCells(&CellWalls::oppositeOfCut) : std::nullopt;
            if (opposite)
                return opposite;
        }
        if (m_count == 0)
            return m_isOnSlope ? std::optional(stays()) : std::nullopt;
        if (m_count == 1)
            return onWallOf(m_seen[0].crossing);
        if (m_count == 3)
            return tip();
        if (m_count != 2 || m_seen[0].step.isOpposite(m_seen[1].step))
            return stays(); // walls on opposite sides: it cannot be on both
        const RimCrossing& a = m_seen[0].crossing;
        const RimCrossing& b = m_seen[1].crossing;
        const OnWall wall = onWall(a, b);
        return WallPlace{wall.at, heightBeside(a, b), wall.normal, a.isUpright && b.isUpright,
                         m_high,  footBeside(a, b)};
    }

private:
    [[nodiscard]] WallPlace onWallOf(const RimCrossing& crossing) const {
        return {crossing.at, crossing.height, crossing.normal, crossing.isUpright, m_high, crossing.foot};
    }
    /// Between walls on both sides: where the wall ahead of it stands.
    [[nodiscard]] WallPlace tip() const {
        for (std::size_t k = 0; k < 3; ++k) {
            const Seen& ahead = m_seen[k];
            const auto faces = [&](const Seen& other) { return other.step.isOpposite(ahead.step); };
            if (std::none_of(m_seen.begin(), m_seen.begin() + 3, faces))
                return onWallOf(ahead.crossing);
        }
        return stays();
    }
    /// It is beside a wall all the same.
    [[nodiscard]] WallPlace stays() const {
        const bool isUpright =
            m_count > 0 && !m_isOnSlope &&
            std::all_of(m_seen.begin(), m_seen.begin() + static_cast<std::ptrdiff_t>(m_count),
                        [](const Seen& seen) { return seen.crossing.isUpright; });
        return {Vec2(0), static_cast<double>(m_around.height(m_i, m_j)), Vec2(0), isUpright, m_high};
    }

    /// Whether nothing is left at a point of the border, nor beside it along the border: nothing is drawn
    /// there, so that it may leave the border for a wall inside.
    [[nodiscard]] bool isOutsideStock() const {
        const Grid& grid = m_around.grid();
        const auto isNothing = [&](int i, int j) {
            const bool isInMap = i >= 0 && j >= 0 && i < grid.nx && j < grid.ny;
            const bool isOnBorder = i == 0 || j == 0 || i == grid.nx - 1 || j == grid.ny - 1;
            return !isInMap || !isOnBorder || m_around.isOnFloor(i, j);
        };
        return isNothing(m_i, m_j) && isNothing(m_i - 1, m_j) && isNothing(m_i + 1, m_j) &&
               isNothing(m_i, m_j - 1) && isNothing(m_i, m_j + 1);
    }

    struct Seen {
        GridStep step;
        RimCrossing crossing;
    };

    void look(const GridStep& step) {
        const int i = m_i + step.di;
        const int j = m_j + step.dj;
        if (i < 0 || j < 0 || i >= m_around.grid().nx || j >= m_around.grid().ny)
            return;
        const bool high = m_around.isHigh(m_i, m_j, step);
        const auto crossing = m_around.crossing(m_i, m_j, step, high);
        if (!crossing) {
            m_isOnSlope = m_isOnSlope || m_around.crossing(m_i, m_j, step, !high).has_value();
            return;
        }
        m_mixed = m_mixed || (m_count > 0 && high != m_high);
        m_high = high;
        m_seen[m_count++] = {step, *crossing};
    }

    /// From the first of the four cells around the point that has an answer.
    [[nodiscard]] std::optional<WallPlace> ofCells(std::optional<WallPlace> (CellWalls::*ask)(int)
                                                       const) const {
        for (int corner = 0; corner < 4; ++corner) {
            for (const bool high : {false, true}) {
                const int i = m_i - corner % 2;
                const int j = m_j - corner / 2;
                const CellWalls* cell = m_cells.twoWalls(i, j, high);
                if (const auto place = cell != nullptr ? (cell->*ask)(corner) : std::nullopt)
                    return place;
            }
        }
        return std::nullopt;
    }

    const RimSurroundings& m_around;
    CellsOfTile& m_cells;
    int m_i;
    int m_j;
    bool m_freeX = false; ///< not on the border of the map
    bool m_freeY = false;
    bool m_isFree = false; ///< to move to any place around it
    bool m_high = false;
    bool m_mixed = false;     ///< both above one wall and below another: it stays
    bool m_isOnSlope = false; ///< that begins or ends before the next point: beside the crease, it stays
    std::array<Seen, kSteps.size()> m_seen{};
    std::size_t m_count = 0;
};

/// The places of a tile's points and of those around it, made when one asks.
class PlacesOfTile {
public:
    explicit PlacesOfTile(const RimSurroundings& around) : m_around(around), m_cells(around) {}

    [[nodiscard]] const std::optional<WallPlace>& at(int i, int j) {
        const auto x = static_cast<std::size_t>(i - m_around.rect().i0 + 1);
        const auto y = static_cast<std::size_t>(j - m_around.rect().j0 + 1);
        std::uint16_t& known = m_known.at(y * kSide + x);
        if (known == 0) {
            m_places.push_back(PointPlace(m_around, m_cells, i, j).place());
            known = static_cast<std::uint16_t>(m_places.size());
        }
        return m_places[known - 1U];
    }

private:
    static constexpr std::size_t kSide = Tile::kSize + 2;

    const RimSurroundings& m_around;
    CellsOfTile m_cells;
    std::deque<std::optional<WallPlace>> m_places;
    std::array<std::uint16_t, kSide * kSide> m_known{}; ///< its place, from 1 on
};

/// The height of a point on a wall with a foot. The surface next to it is drawn straight from the wall to
/// points that stay, though the foot sags between them: it is put so much lower than the wall's end that as
/// much is under its triangles as under the foot.
class PointAboveFoot {
public:
    PointAboveFoot(const RimSurroundings& around, PlacesOfTile& places, int i, int j)
        : m_around(around), m_places(places), m_i(i), m_j(j), m_wall(*places.at(i, j)) {
        const Vec2 out = m_wall.normal == Vec2(0) ? m_wall.at : m_wall.normal;
        m_out = out == Vec2(0) ? out : glm::normalize(out);
    }

    [[nodiscard]] double height() {
        for (int j = std::max(m_j - 1, 0); j <= std::min(m_j, m_around.grid().ny - 2); ++j) {
            for (int i = std::max(m_i - 1, 0); i <= std::min(m_i, m_around.grid().nx - 2); ++i)
                addCell(i, j);
        }
        if (!(m_area > 0))
            return m_wall.z;
        const double lower = m_wall.foot.sagBeyond(m_farthest / m_area, step()) - 3 * m_volume / m_area;
        return std::clamp(m_wall.z - lower, m_lowest, m_wall.z);
    }

private:
    struct Corner {
        Vec2 at; ///< from the point of the grid
        double z;
        bool isOnFoot; ///< where it begins, at the wall
        bool isAboveWall;
        bool isThis;
    };

    /// Of the grid, away from the wall.
    [[nodiscard]] double step() const {
        const Vec2 steps = glm::abs(m_out) * m_around.cell();
        return std::max(steps.x, steps.y);
    }
    void addCell(int i, int j) {
        const std::array<Corner, 4> at{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                       corner(i, j + 1)};
        if ((i + j) % 2 == 0) {
            add({at[0], at[1], at[2]});
            add({at[0], at[2], at[3]});
        } else {
            add({at[0], at[1], at[3]});
            add({at[1], at[2], at[3]});
        }
    }
    [[nodiscard]] Corner corner(int i, int j) {
        const Vec2 grid(m_around.cell() * Vec2(i - m_i, j - m_j));
        const std::optional<WallPlace>& wall = m_places.at(i, j);
        const bool isThis = i == m_i && j == m_j;
        if (!wall)
            return {grid, static_cast<double>(m_around.height(i, j)), false, false, isThis};
        return {grid + wall->at, wall->z, !wall->foot.isLevel(), wall->isHigh, isThis};
    }
    void add(const std::array<Corner, 3>& corners) {
        std::array<double, 3> distances{};
        double onFoot = 0;
        double straight = 0;
        bool hasThis = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const Corner& one = corners[k];
            if (one.isAboveWall)
                return;
            hasThis = hasThis || one.isThis;
            onFoot += one.isOnFoot ? 1 : 0;
            distances[k] = one.isOnFoot ? 0 : std::max(0.0, glm::dot(m_wall.at - one.at, m_out));
            straight += m_wall.foot.fall(distances[k]) / 3;
        }
        const Vec2 a = corners[1].at - corners[0].at;
        const Vec2 b = corners[2].at - corners[0].at;
        const double area = (a.x * b.y - a.y * b.x) / 2;
        if (!hasThis || !(area > 0))
            return;
        for (const Corner& one : corners)
            m_lowest = std::min(m_lowest, one.z);
        m_area += area;
        m_farthest += area * *std::ranges::max_element(distances);
        m_volume += area * (straight - m_wall.foot.meanFall(distances)) / onFoot;
    }

    const RimSurroundings& m_around;
    PlacesOfTile& m_places;
    int m_i;
    int m_j;
    const WallPlace& m_wall;
    Vec2 m_out;            ///< over ground, from the foot to the wall
    double m_area = 0;     ///< of the triangles around it
    double m_farthest = 0; ///< how far they reach from the wall, times it
    double m_volume = 0;   ///< between them and the foot, its share
    double m_lowest = std::numeric_limits<double>::infinity();
};

bool sameAround(const ZMapSnapshot& a, const RimMap& before, std::size_t tile) {
    const int i = static_cast<int>(tile) % a.tilesX();
    const int j = static_cast<int>(tile) / a.tilesX();
    for (int tj = std::max(j - 1, 0); tj <= std::min(j + 1, a.tilesY() - 1); ++tj) {
        for (int ti = std::max(i - 1, 0); ti <= std::min(i + 1, a.tilesX() - 1); ++ti) {
            const auto index = static_cast<std::size_t>(tj * a.tilesX() + ti);
            if (a.rims()[index] != before[index])
                return false;
        }
    }
    return true;
}

/// A way from a point that does not leave the map: round walls are estimated between rims.
Vec2 insideMap(const Grid& grid, int i, int j, const Vec2& way) {
    const Vec2 point(grid.x(i), grid.y(j));
    return glm::clamp(way, Vec2(grid.x(0), grid.y(0)) - point,
                      Vec2(grid.x(grid.nx - 1), grid.y(grid.ny - 1)) - point);
}

} // namespace

std::shared_ptr<const WallTile> wallPointsOf(const ZMapSnapshot& zmap, std::size_t tile) {
    if (zmap.rims().empty())
        return nullptr;
    const RimSurroundings around(zmap, tile);
    if (around.empty())
        return nullptr;
    PlacesOfTile places(around);
    WallTile walls;
    const IndexRect& rect = around.rect();
    for (int j = rect.j0; j < rect.j1; ++j) {
        for (int i = rect.i0; i < rect.i1; ++i) {
            if (!around.isNearRim(i, j))
                continue;
            const std::optional<WallPlace>& place = places.at(i, j);
            if (!place)
                continue;
            const double z = place->foot.isLevel() ? place->z : PointAboveFoot(around, places, i, j).height();
            const Vec2 at = insideMap(around.grid(), i, j, place->at);
            walls.points.push_back({static_cast<std::uint16_t>((j - rect.j0) * Tile::kSize + i - rect.i0),
                                    place->isUpright, static_cast<float>(at.x), static_cast<float>(at.y),
                                    static_cast<float>(z), inRimUnits(place->normal.x),
                                    inRimUnits(place->normal.y)});
        }
    }
    return walls.points.empty() ? nullptr : std::make_shared<const WallTile>(std::move(walls));
}

WallPoints::WallPoints(const ZMapSnapshot& zmap) : WallPoints(zmap, {}, {}) {}

WallPoints::WallPoints(const ZMapSnapshot& zmap, const RimMap& before, const WallPoints& points)
    : m_tilesX(zmap.tilesX()) {
    if (zmap.rims().empty())
        return;
    const bool follows = before.size() == zmap.tileCount() && points.m_tiles.size() == zmap.tileCount();
    std::vector<std::shared_ptr<const WallTile>> tiles(zmap.tileCount());
    inParallel(tiles.size(), [&](std::size_t tile) {
        const std::shared_ptr<const WallTile> last = follows ? points.m_tiles[tile] : nullptr;
        if (follows && sameAround(zmap, before, tile)) {
            tiles[tile] = last;
            return;
        }
        tiles[tile] = wallPointsOf(zmap, tile);
        if (last && tiles[tile] && *last == *tiles[tile])
            tiles[tile] = last;
    });
    for (std::shared_ptr<const WallTile>& tile : tiles) {
        m_count += tile ? tile->points.size() : 0;
        m_tiles.push_back(std::move(tile));
    }
}

const WallPoint* WallPoints::find(int i, int j) const {
    if (m_count == 0)
        return nullptr;
    const WallTile* walls =
        m_tiles[static_cast<std::size_t>(j / Tile::kSize * m_tilesX + i / Tile::kSize)].get();
    if (walls == nullptr)
        return nullptr;
    const int point = j % Tile::kSize * Tile::kSize + i % Tile::kSize;
    const auto at = std::ranges::lower_bound(walls->points, point, {}, &WallPoint::point);
    return at != walls->points.end() && at->point == point ? &*at : nullptr;
}

void WallPoints::removeIn(const IndexRect& rect) {
    eachTileIn(rect, [&](std::size_t index, const IndexRect& within) {
        const auto isInside = [&](const WallPoint& wall) {
            const int i = wall.point % Tile::kSize;
            const int j = wall.point / Tile::kSize;
            return i >= within.i0 && i < within.i1 && j >= within.j0 && j < within.j1;
        };
        const std::size_t removed =
            static_cast<std::size_t>(std::ranges::count_if(m_tiles[index]->points, isInside));
        if (removed == 0)
            return;
        auto left = std::make_shared<WallTile>(*m_tiles[index]);
        std::erase_if(left->points, isInside);
        m_tiles.edit(index) = left->points.empty() ? nullptr : std::move(left);
        m_count -= removed;
    });
}

std::vector<std::uint32_t> WallPoints::offsetsIn(const IndexRect& rect) const {
    std::vector<std::uint32_t> offsets;
    eachTileIn(rect, [&](std::size_t index, const IndexRect& within) {
        for (const WallPoint& wall : m_tiles[index]->points) {
            const int i = wall.point % Tile::kSize - within.i0;
            const int j = wall.point / Tile::kSize - within.j0;
            if (i >= 0 && j >= 0 && i < rect.width() && j < rect.height())
                offsets.push_back(static_cast<std::uint32_t>(j * rect.width() + i));
        }
    });
    std::ranges::sort(offsets);
    return offsets;
}

template<class Visit>
void WallPoints::eachTileIn(const IndexRect& rect, const Visit& visit) const {
    if (m_count == 0 || rect.empty())
        return;
    const int rows = static_cast<int>(m_tiles.size()) / m_tilesX;
    const int lastJ = std::min((rect.j1 - 1) / Tile::kSize, rows - 1);
    const int lastI = std::min((rect.i1 - 1) / Tile::kSize, m_tilesX - 1);
    for (int tj = std::max(rect.j0, 0) / Tile::kSize; tj <= lastJ; ++tj) {
        for (int ti = std::max(rect.i0, 0) / Tile::kSize; ti <= lastI; ++ti) {
            const auto index = static_cast<std::size_t>(tj * m_tilesX + ti);
            const int i = ti * Tile::kSize;
            const int j = tj * Tile::kSize;
            if (m_tiles[index] != nullptr)
                visit(index, IndexRect{rect.i0 - i, rect.j0 - j, rect.i1 - i, rect.j1 - j});
        }
    }
}

Vec3 vertexAt(const ZMapSnapshot& zmap, int i, int j) {
    const Grid& grid = zmap.grid();
    const double top = zmap.stock().topZ();
    const WallPoint* wall = zmap.walls().find(i, j);
    if (wall == nullptr)
        return {grid.x(i), grid.y(j), top + static_cast<double>(zmap.height(i, j))};
    return {grid.x(i) + static_cast<double>(wall->dx), grid.y(j) + static_cast<double>(wall->dy),
            top + static_cast<double>(wall->z)};
}

} // namespace proveout
