// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps into one tile.
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

/// A sweep, and how inner loops see it over the grid of a map.
struct PreparedSweep {
    Sweep sweep;
    SweepPasses passes;     ///< none: it is asked row by row
    std::uint32_t mark = 1; ///< as of its CutterMotion

    PreparedSweep() = default; ///< cuts nothing
    PreparedSweep(const Cutter& cutter, const Motion& motion, const ZMap& zmap)
        : sweep(cutter, motion, zmap.stock().topZ()), passes(sweep.passes(zmap.grid().hx, zmap.grid().hy)) {}

    /// The work on one point at most, as a multiple of that on a point of a straight motion.
    [[nodiscard]] double costOfPoint() const {
        return passes.empty() ? sweep.costOfPoint() : passes.costOfPoint();
    }
};

struct TileCut {
    std::shared_ptr<Tile> copy; ///< the lowered tile, where a snapshot shares the old one
    bool complete = true;       ///< false where it was stopped on the way
};

/// Lowers tile `index` of the map in place, or a copy of it where it is shared, by those of `sweeps` that
/// `order` names, one after the other; a tile of which nothing changes is never copied. `records`, one for
/// each of `order`, are what they did; `removedMm3` of them is the sum of heights, not yet times the cell's
/// area. Different tiles may be lowered at once. Looks at `stop` at every row or block: what was lowered in
/// place until then stays lowered. `marks`, unless it is null: points that become lower get the sweep's mark.
[[nodiscard]] TileCut lowerTile(ZMap& zmap, std::size_t index, std::span<const PreparedSweep> sweeps,
                                std::span<const std::uint32_t> order, std::span<CutRecord> records,
                                const std::stop_token& stop, Provenance::Marks* marks = nullptr);

/// The same heights, without records, in whatever order is fastest. `table` is room to work in; `place` is
/// where the points of the map lie.
[[nodiscard]] TileCut lowerTileByAll(ZMap& zmap, std::size_t index, std::span<const PreparedSweep> sweeps,
                                     std::span<const std::uint32_t> order, PassTable& table,
                                     const GridPart& place, const std::stop_token& stop);

} // namespace proveout
