// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/turned_rims.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace proveout {

namespace {

struct GridPoint {
    int i, j;
};

/// Where the point of a grid is after it was turned.
GridPoint turnedPoint(const GridPoint& at, const Grid& grid, StockTurn turn) {
    switch (turn) {
    case StockTurn::quarter:
        return {grid.ny - 1 - at.j, at.i};
    case StockTurn::half:
        return {grid.nx - 1 - at.i, grid.ny - 1 - at.j};
    case StockTurn::threeQuarters:
        return {at.j, grid.nx - 1 - at.i};
    default:
        return at;
    }
}

struct RimNormal {
    std::int16_t x, y;
};

RimNormal turnedNormal(const RimNormal& n, StockTurn turn) {
    const auto negative = [](std::int16_t part) { return static_cast<std::int16_t>(-part); };
    switch (turn) {
    case StockTurn::quarter:
        return {negative(n.y), n.x};
    case StockTurn::half:
        return {negative(n.x), negative(n.y)};
    case StockTurn::threeQuarters:
        return {n.y, negative(n.x)};
    default:
        return n;
    }
}

/// Half a turn about a horizontal axis.
GridPoint flippedPoint(const GridPoint& at, const Grid& grid, StockFlip flip) {
    return flip == StockFlip::aboutX ? GridPoint{at.i, grid.ny - 1 - at.j}
                                     : GridPoint{grid.nx - 1 - at.i, at.j};
}

RimNormal flippedNormal(const RimNormal& n, StockFlip flip) {
    return flip == StockFlip::aboutX ? RimNormal{n.x, static_cast<std::int16_t>(-n.y)}
                                     : RimNormal{static_cast<std::int16_t>(-n.x), n.y};
}

/// From the other end. The last place of an edge is not 65536, so that this is off by one: twice gives the
/// same.
std::uint16_t fromEnd(std::uint16_t place) {
    return static_cast<std::uint16_t>(65535 - place);
}

/// The tiles of a map whose points have moved, each by `PointOf`, and its normals by `NormalOf`.
template<class PointOf, class NormalOf>
class MovedTiles {
public:
    /// `columns`: of tiles, in the moved map.
    MovedTiles(std::size_t tiles, int columns, PointOf pointOf, NormalOf normalOf)
        : m_pointOf(std::move(pointOf)), m_normalOf(std::move(normalOf)), m_columns(columns), m_tiles(tiles) {
    }

    void add(const IndexRect& tile, Rim rim) {
        const MovedEdge moved = movedEdge(tile, rim.edge);
        if (moved.isReversed) {
            rim.highPlace = fromEnd(rim.highPlace);
            rim.lowPlace = fromEnd(rim.lowPlace);
        }
        const RimNormal normal = m_normalOf(RimNormal{rim.normalX, rim.normalY});
        rim.normalX = normal.x;
        rim.normalY = normal.y;
        rim.edge = moved.edge;
        tileAt(moved.at).rims.push_back(rim);
    }
    void addUnseenRib(const IndexRect& tile, std::uint16_t edge) {
        const MovedEdge moved = movedEdge(tile, edge);
        tileAt(moved.at).unseenRibs.push_back(moved.edge);
    }
    /// The tiles in which its points are now.
    void addUnknown(const IndexRect& tile) {
        const GridPoint first = m_pointOf(GridPoint{tile.i0, tile.j0});
        const GridPoint last = m_pointOf(GridPoint{tile.i1 - 1, tile.j1 - 1});
        const auto [i0, i1] = std::minmax(first.i, last.i);
        const auto [j0, j1] = std::minmax(first.j, last.j);
        for (const int j : {j0, j1})
            for (const int i : {i0, i1})
                tileAt({i, j}).areUnknown = true;
    }
    [[nodiscard]] RimMap take() {
        RimMap rims;
        for (RimTile& tile : m_tiles) {
            std::ranges::sort(tile.rims, {}, &Rim::edge);
            std::ranges::sort(tile.unseenRibs);
            rims.push_back(tile.empty() ? nullptr : std::make_shared<const RimTile>(std::move(tile)));
        }
        return rims;
    }

private:
    struct MovedEdge {
        GridPoint at; ///< its first point
        std::uint16_t edge;
        bool isReversed;
    };
    [[nodiscard]] MovedEdge movedEdge(const IndexRect& tile, std::uint16_t index) const {
        const RimEdge edge = RimEdge::of(index);
        const GridPoint from{tile.i0 + edge.i, tile.j0 + edge.j};
        const GridPoint to{from.i + (edge.alongY ? 0 : 1), from.j + (edge.alongY ? 1 : 0)};
        const auto [first, second] = std::pair(m_pointOf(from), m_pointOf(to));
        const bool isReversed = second.i + second.j < first.i + first.j;
        const GridPoint at = isReversed ? second : first;
        return {at, RimEdge{at.i % Tile::kSize, at.j % Tile::kSize, first.i == second.i}.index(), isReversed};
    }
    [[nodiscard]] RimTile& tileAt(const GridPoint& at) {
        return m_tiles[static_cast<std::size_t>(at.j / Tile::kSize * m_columns + at.i / Tile::kSize)];
    }

    PointOf m_pointOf;
    NormalOf m_normalOf;
    int m_columns;
    std::vector<RimTile> m_tiles;
};

/// Calls `visit` with the points and the rims of each tile that has some.
template<class Visit>
void eachTile(const ZMapSnapshot& map, const Visit& visit) {
    for (std::size_t tile = 0; tile < map.tileCount(); ++tile)
        if (const RimTilePtr& rims = map.rims()[tile])
            visit(map.tileRect(tile), *rims);
}

} // namespace

RimMap turnedRims(const ZMapSnapshot& map, StockTurn turn) {
    if (map.rims().empty())
        return {};
    const bool keepsAxes = turn == StockTurn::half || turn == StockTurn::none;
    MovedTiles turned(
        map.tileCount(), keepsAxes ? map.tilesX() : map.tilesY(),
        [&](const GridPoint& at) { return turnedPoint(at, map.grid(), turn); },
        [&](const RimNormal& normal) { return turnedNormal(normal, turn); });
    eachTile(map, [&](const IndexRect& rect, const RimTile& tile) {
        for (const Rim& rim : tile.rims)
            turned.add(rect, rim);
        for (const std::uint16_t edge : tile.unseenRibs)
            turned.addUnseenRib(rect, edge);
        if (tile.areUnknown)
            turned.addUnknown(rect);
    });
    return turned.take();
}

RimMap rimsWithin(const ZMapSnapshot& map, const IndexRect& rect) {
    const auto tiles = [](int points) { return (points + Tile::kSize - 1) / Tile::kSize; };
    const int columns = tiles(rect.width());
    MovedTiles moved(
        static_cast<std::size_t>(columns) * static_cast<std::size_t>(tiles(rect.height())), columns,
        [&](const GridPoint& at) {
            return GridPoint{at.i - rect.i0, at.j - rect.j0};
        },
        [](const RimNormal& normal) { return normal; });
    eachTile(map, [&](const IndexRect& of, const RimTile& tile) {
        const IndexRect inside = intersection(of, rect);
        if (inside.empty())
            return;
        const auto isInside = [&](std::uint16_t index) {
            const RimEdge edge = RimEdge::of(index);
            const int i = of.i0 + edge.i;
            const int j = of.j0 + edge.j;
            return i >= rect.i0 && j >= rect.j0 && i + (edge.alongY ? 0 : 1) < rect.i1 &&
                   j + (edge.alongY ? 1 : 0) < rect.j1;
        };
        for (const Rim& rim : tile.rims)
            if (isInside(rim.edge))
                moved.add(of, rim);
        for (const std::uint16_t edge : tile.unseenRibs)
            if (isInside(edge))
                moved.addUnseenRib(of, edge);
        if (tile.areUnknown)
            moved.addUnknown(inside);
    });
    return moved.take();
}

RimMap flippedRims(const ZMapSnapshot& map, StockFlip flip, float floor) {
    if (map.rims().empty())
        return {};
    MovedTiles flipped(
        map.tileCount(), map.tilesX(),
        [&](const GridPoint& at) { return flippedPoint(at, map.grid(), flip); },
        [&](const RimNormal& normal) { return flippedNormal(normal, flip); });
    const auto isThrough = [&](const IndexRect& rect, std::uint16_t index) {
        const RimEdge edge = RimEdge::of(index);
        const int i = rect.i0 + edge.i;
        const int j = rect.j0 + edge.j;
        return std::max(map.height(i, j), map.height(i + (edge.alongY ? 0 : 1), j + (edge.alongY ? 1 : 0))) <=
               map.floor();
    };
    eachTile(map, [&](const IndexRect& rect, const RimTile& tile) {
        for (Rim rim : tile.rims) {
            if (!rim.has(false) || rim.bottom > map.floor())
                continue;
            rim.sides = RimSides::both;
            rim.highPlace =
                rim.lowPlace; // where it meets the old floor; from there down it is air or undercut
            rim.top = 0;
            rim.bottom = floor;
            flipped.add(rect, rim);
        }
        for (const std::uint16_t edge : tile.unseenRibs)
            if (isThrough(rect, edge)) // what is between other floors is material under the new top
                flipped.addUnseenRib(rect, edge);
        if (tile.areUnknown)
            flipped.addUnknown(rect);
    });
    return flipped.take();
}

} // namespace proveout
