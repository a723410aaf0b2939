// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/zmap/stock_shape.h"

namespace proveout {

/// What an earlier set-up has left as the stock of the next one: flipped by half a turn about an axis that
/// lies, then turned. Its box keeps its corner.
///
/// Turning loses nothing: the heights are the same to the last bit. Flipping puts the old floor on top and
/// cuts the box where the old surface was highest; what had been cut into the old surface is air under the
/// new one, which a z-map cannot hold and which is measured and told.
///
/// On another grid, between whose points the saved ones lie, the surface is nowhere lower at a saved point
/// than it was: each point takes the higher of the saved surface there and the highest saved point nearer
/// than a spacing. A note tells so. Where every saved point is a point of the grid nothing changes.
///
/// `spacing` is the one that the grid of `saved` was made with. The map is kept, and its tiles are shared
/// where they serve as they are. Errors: nothing is left of the stock to flip.
[[nodiscard]] Result<std::shared_ptr<const StockBody>> savedStock(const ZMapSnapshot& saved, double spacing,
                                                                  StockTurn turn = StockTurn::none,
                                                                  StockFlip flip = StockFlip::none);

} // namespace proveout
