// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/zmap/rims.h"
#include "core/zmap/stock_shape.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The rims of a map for the map that is turned; empty if it has none. Tiles that are unknown make all those
/// unknown that have points of them then. Internal to this library.
[[nodiscard]] RimMap turnedRims(const ZMapSnapshot& map, StockTurn turn);

/// The same for the map that is flipped, whose top is the old floor: the walls that came down to that,
/// upright below where they met it, and ribs between floors that are the old one. `floor`: the new one,
/// relative to the new top.
[[nodiscard]] RimMap flippedRims(const ZMapSnapshot& map, StockFlip flip, float floor);

/// The rims on edges within a rectangle of grid points, for a map of these points alone. It may reach beyond
/// the map.
[[nodiscard]] RimMap rimsWithin(const ZMapSnapshot& map, const IndexRect& rect);

} // namespace proveout
