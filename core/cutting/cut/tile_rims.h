// SPDX-License-Identifier: GPL-3.0-or-later
// Where walls cross the edges of a grid, exactly, from the motions that made them. Heights are not changed.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/falling_edges.h"
#include "core/cutting/cut/near_sweeps.h"
#include "core/zmap/rims.h"
#include "core/zmap/stock_shape.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Finds the rims of a tile of `zmap` motion by motion, so that not all of them are in memory. Refers to the
/// map. Owned by one thread.
class TileRimSearch {
public:
    TileRimSearch(const ZMapSnapshot& zmap, std::size_t tile, RimEdges wanted);

    /// Whether there are no rims, whatever was cut.
    [[nodiscard]] bool hasNone() const { return m_edges.empty(); }
    void add(const CutterMotion& motion) { m_sweeps.add(motion); }
    /// Whether the rims are unknown, whatever else was cut.
    [[nodiscard]] bool isFull() const { return m_sweeps.isFull(); }
    /// As rimsOfTile(). Call it once.
    [[nodiscard]] RimTilePtr find(const StockTop* uncut, const std::stop_token& stop);

private:
    [[nodiscard]] std::optional<Rim> rimOf(const FallingEdge& edge, const StockTop* uncut);

    const ZMapSnapshot& m_zmap;
    std::size_t m_index;
    IndexRect m_tile;
    RimEdges m_wanted;
    std::vector<FallingEdge> m_edges;
    NearSweeps m_sweeps;
    const RimTile* m_ofStock = nullptr; ///< what the stock knows of its own walls, if not all
    bool m_missesWalls = false;         ///< of the stock
};

/// The rims of a tile of `zmap` after exactly `motions` have been cut, in any order, from a stock whose top
/// was `uncut` (null: the whole box). Motions that cannot reach the tile may be left out. Null if there is no
/// rim, and after a stop; without rims, and unknown, if more than kMostMotionsOfRims motions are near its
/// edges. Any thread. The result is the same for any order of the motions, to the last bit.
///
/// On each edge that falls more steeply than the one before it (falling_edges.h), the surface first falls
/// below a line a little lower than the continuation of the plateau at the edge's high end; that place is a
/// rim if the surface falls by a jump there. Between levels, the wall includes what follows within a 64th of
/// the edge: passes at several depths make one wall. With RimEdges::atLevels, the creases where a tapered
/// wall or any other slope leaves a level, or comes down to one, are rims too, each with the side that is
/// level. Walls of a stock that does not know them (StockTop::knowsWalls()) are those that it has rims of
/// (StockTop::rims()): the same bits where nothing cut them. Where its own rims are unknown and it may have a
/// wall, so are those of the tile.
[[nodiscard]] RimTilePtr rimsOfTile(const ZMapSnapshot& zmap, std::size_t tile, const StockTop* uncut,
                                    std::span<const CutterMotion> motions, const std::stop_token& stop = {},
                                    RimEdges wanted = RimEdges::all);

} // namespace proveout
