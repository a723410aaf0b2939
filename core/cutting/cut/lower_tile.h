// SPDX-License-Identifier: GPL-3.0-or-later
// Lowers one tile by sweeps.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/sweep.h"
#include "core/cutting/kernels/tile_kernel.h"
#include "core/zmap/grid_part.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// A sweep and its passes for the inner loops over the grid of a map.
struct PreparedSweep {
    Sweep sweep;
    SweepPasses passes;     ///< empty: the sweep is evaluated row by row
    std::uint32_t mark = 1; ///< as of its CutterMotion
    bool recorded = true;   ///< as of its CutterMotion

    PreparedSweep() = default; ///< a sweep that cuts nothing
    PreparedSweep(const Cutter& cutter, const Motion& motion, const ZMap& zmap, bool continues = false)
        : sweep(cutter, motion, zmap.stock().topZ(), continues),
          passes(sweep.passes(zmap.grid().hx, zmap.grid().hy)) {}

    /// The largest work on one point, as a multiple of that on a point of a straight motion.
    [[nodiscard]] double costOfPoint() const {
        return passes.empty() ? sweep.costOfPoint() : passes.costOfPoint();
    }
};

struct TileCut {
    std::shared_ptr<Tile> copy; ///< the lowered tile, if a snapshot shares the old one
    bool complete = true;       ///< false if it was stopped before the end
};

/// Lowers tile `index` of the map in place, or a copy of it if it is shared, by the `sweeps` that `order`
/// lists, one after the other; a tile in which nothing changes is never copied. `records`, one per entry of
/// `order`, are the results; their `removedMm3` is the sum of heights, not yet times the cell's area.
/// Different tiles may be lowered at once. Checks `stop` at every row or block: what was lowered in place
/// until then stays lowered. `marks`, unless it is null: points that are lowered get the sweep's mark.
[[nodiscard]] TileCut lowerTile(ZMap& zmap, std::size_t index, std::span<const PreparedSweep> sweeps,
                                std::span<const std::uint32_t> order, std::span<CutRecord> records,
                                const std::stop_token& stop, Provenance::Marks* marks = nullptr);

/// The same heights, but `records` has one entry per sweep of `order` that is recorded: between two of these
/// the others are cut in the fastest order. `table` is scratch memory.
[[nodiscard]] TileCut lowerTileInTurn(ZMap& zmap, std::size_t index, std::span<const PreparedSweep> sweeps,
                                      std::span<const std::uint32_t> order, std::span<CutRecord> records,
                                      PassTable& table, const std::stop_token& stop);

/// The same heights, without records, in the fastest order. `table` is scratch memory; `place` gives the
/// positions of the points of the map.
[[nodiscard]] TileCut lowerTileByAll(ZMap& zmap, std::size_t index, std::span<const PreparedSweep> sweeps,
                                     std::span<const std::uint32_t> order, PassTable& table,
                                     const GridPart& place, const std::stop_token& stop);

} // namespace proveout
