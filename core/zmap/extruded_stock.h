// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/zmap/stock_shape.h"

namespace proveout {

/// A corner of an outline, and how it goes on to the next one: `bulge` is the tangent of a quarter of the
/// angle of an arc, counter-clockwise above 0; 0 is a line, 1 half a circle.
struct OutlinePoint {
    Vec2 at{0};
    double bulge = 0;
};
/// Closed: the last point goes on to the first.
using OutlineLoop = std::vector<OutlinePoint>;

/// The area within loops, a loop in another being a hole, extruded from `topZ` down by `height`; the outline
/// itself belongs to it. Errors: no loop with an area, an outline that crosses itself, or numbers that are
/// none or beyond 10 km.
[[nodiscard]] Result<std::shared_ptr<const StockBody>> extrudedStock(const std::vector<OutlineLoop>& loops,
                                                                     double height, double topZ = 0);

/// A circle that touches both axes from above, so that the corner of its box lies at 0.
[[nodiscard]] OutlineLoop circleOutline(double diameter);

} // namespace proveout
