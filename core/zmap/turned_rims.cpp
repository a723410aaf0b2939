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

/// The tiles of a map whose points have moved.
class MovedTiles {
public:
    /// `columns`: of tiles, in the moved map.
    MovedTiles(std::size_t tiles, int columns) : m_columns(columns), m_tiles(tiles) {}

    /// `pointOf`, `normalOf`: where a point and a normal are then.
    template<class PointOf, class NormalOf>
    void add(const IndexRect& tile, Rim rim, const PointOf& pointOf, const NormalOf& normalOf) {
        const RimEdge edge = RimEdge::of(rim.edge);
        const GridPoint from{tile.i0 + edge.i, tile.j0 + edge.j};
        const GridPoint to{from.i + (edge.alongY ? 0 : 1), from.j + (edge.alongY ? 1 : 0)};
        const auto [first, second] = std::pair(pointOf(from), pointOf(to));
        const bool reversed = second.i + second.j < first.i + first.j;
        if (reversed) {
            rim.highPlace = fromEnd(rim.highPlace);
            rim.lowPlace = fromEnd(rim.lowPlace);
        }
        const RimNormal normal = normalOf(RimNormal{rim.normalX, rim.normalY});
        rim.normalX = normal.x;
        rim.normalY = normal.y;
        const GridPoint at = reversed ? second : first;
        rim.edge = RimEdge{at.i % Tile::kSize, at.j % Tile::kSize, first.i == second.i}.index();
        tileAt(at).push_back(rim);
    }
    [[nodiscard]] RimMap take() {
        RimMap rims;
        for (std::vector<Rim>& tile : m_tiles) {
            std::ranges::sort(tile, {}, &Rim::edge);
            rims.push_back(tile.empty() ? nullptr
                                        : std::make_shared<const RimTile>(RimTile{std::move(tile), false}));
        }
        return rims;
    }

private:
    [[nodiscard]] std::vector<Rim>& tileAt(const GridPoint& at) {
        return m_tiles[static_cast<std::size_t>(at.j / Tile::kSize * m_columns + at.i / Tile::kSize)];
    }

    int m_columns;
    std::vector<std::vector<Rim>> m_tiles;
};

template<class Visit>
void eachRim(const ZMapSnapshot& map, const Visit& visit) {
    for (std::size_t tile = 0; tile < map.tileCount(); ++tile)
        if (const RimTilePtr& rims = map.rims()[tile])
            for (const Rim& rim : rims->rims)
                visit(map.tileRect(tile), rim);
}

} // namespace

RimMap turnedRims(const ZMapSnapshot& map, StockTurn turn) {
    if (map.rims().empty())
        return {};
    const bool keepsAxes = turn == StockTurn::half || turn == StockTurn::none;
    MovedTiles turned(map.tileCount(), keepsAxes ? map.tilesX() : map.tilesY());
    eachRim(map, [&](const IndexRect& tile, const Rim& rim) {
        turned.add(
            tile, rim, [&](const GridPoint& at) { return turnedPoint(at, map.grid(), turn); },
            [&](const RimNormal& normal) { return turnedNormal(normal, turn); });
    });
    return turned.take();
}

RimMap flippedRims(const ZMapSnapshot& map, StockFlip flip, float floor) {
    if (map.rims().empty())
        return {};
    MovedTiles flipped(map.tileCount(), map.tilesX());
    eachRim(map, [&](const IndexRect& tile, Rim rim) {
        if (!rim.has(false) || rim.bottom > map.floor())
            return;
        rim.sides = RimSides::both;
        rim.highPlace = rim.lowPlace; // where it meets the old floor; from there down it is air or undercut
        rim.top = 0;
        rim.bottom = floor;
        flipped.add(
            tile, rim, [&](const GridPoint& at) { return flippedPoint(at, map.grid(), flip); },
            [&](const RimNormal& normal) { return flippedNormal(normal, flip); });
    });
    return flipped.take();
}

} // namespace proveout
