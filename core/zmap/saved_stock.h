// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/zmap/stock_shape.h"

namespace proveout {

/// The stock left by an earlier setup as the stock of the next one: flipped by half a turn about a horizontal
/// axis, then turned. Its box keeps its corner.
///
/// Turning loses nothing: the heights are the same to the last bit, and the rims within 1/65536 of an edge;
/// four quarters give the same bits. After flipping, there are the rims of walls that came down to the old
/// floor; on another grid, or with another height, rims are unknown, which a note reports. Flipping puts the
/// old floor on top and ends the box where the old surface was highest; what had been cut into the old
/// surface is air under the new one, which a z-map cannot represent; it is measured and reported.
///
/// On another grid, whose points do not coincide with the saved ones, the surface is nowhere lower at a saved
/// point than it was: each point gets the higher of the saved surface there and the highest saved point
/// nearer than a spacing. A note reports this. If every saved point is a point of the grid, nothing changes.
///
/// `spacing` is the one that the grid of `saved` was made with. The map is kept, and its tiles are shared
/// where they can be used unchanged. Errors: nothing is left of the stock to flip.
[[nodiscard]] Result<std::shared_ptr<const StockBody>> savedStock(const ZMapSnapshot& saved, double spacing,
                                                                  StockTurn turn = StockTurn::none,
                                                                  StockFlip flip = StockFlip::none);

} // namespace proveout
