// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/zmap/rims.h"
#include "core/zmap/stock_shape.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The rims of a map for the map that is turned; empty if it has none. Internal to this library.
[[nodiscard]] RimMap turnedRims(const ZMapSnapshot& map, StockTurn turn);

/// The same for the map that is flipped, whose top is the old floor: the walls that came down to that,
/// upright below where they met it. `floor`: the new one, relative to the new top.
[[nodiscard]] RimMap flippedRims(const ZMapSnapshot& map, StockFlip flip, float floor);

} // namespace proveout
