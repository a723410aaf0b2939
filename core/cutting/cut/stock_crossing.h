// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cutting/rows/edge_crossing.h"
#include "core/zmap/stock_shape.h"

namespace proveout {

/// The first place where the top of a stock is below a line in program coordinates, with the direction from
/// its low to its high side as `outwards`. A gap narrower than an eighth of the line may be missed.
[[nodiscard]] EdgeCrossing crossingWithStock(const StockTop& stock, const EdgeLine& line);

} // namespace proveout
