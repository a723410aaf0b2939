// SPDX-License-Identifier: GPL-3.0-or-later
// One sweep into one tile.
#pragma once

#include <memory>
#include <span>
#include <stop_token>

#include "core/cutting/cutting.h"
#include "core/cutting/straight_pass.h"
#include "core/cutting/sweep.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// What a sweep did to a tile. `removedMm3` of the record is the sum of heights, not yet times the cell's
/// area.
struct TileCut {
    CutRecord record;
    std::shared_ptr<Tile> copy; ///< the lowered tile, where a snapshot shares the old one
    bool complete = true;       ///< false where it was stopped on the way
};

/// Lowers tile `index` of the map in place, or a copy of it where it is shared; a tile of which nothing
/// changes is never copied. Different tiles may be lowered at once. `passes` are those of the sweep over the
/// map's grid, or none: then it is asked row by row. Looks at `stop` at every row: what was lowered in place
/// until then stays lowered.
[[nodiscard]] TileCut lowerTile(ZMap& zmap, std::size_t index, const Sweep& sweep,
                                std::span<const StraightPass> passes, const std::stop_token& stop);

} // namespace proveout
