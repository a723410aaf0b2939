// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/zmap/stock_shape.h"

namespace proveout {

/// A corner of an outline, and how the outline continues to the next one: `bulge` is the tangent of a quarter
/// of the angle of an arc, counter-clockwise above 0; 0 is a line, 1 half a circle.
struct OutlinePoint {
    Vec2 at{0};
    double bulge = 0;
};
/// Closed: the last point is connected to the first.
using OutlineLoop = std::vector<OutlinePoint>;

/// The area within loops, a loop in another being a hole, extruded from `topZ` down by `height`; the outline
/// itself is part of it. Errors: no loop with an area, an outline that crosses itself, numbers that are not
/// finite or are beyond 10 km.
[[nodiscard]] Result<std::shared_ptr<const StockBody>> extrudedStock(const std::vector<OutlineLoop>& loops,
                                                                     double height, double topZ = 0);

/// A circle in the positive quadrant that touches both axes, so that the corner of its box is at 0.
[[nodiscard]] OutlineLoop circleOutline(double diameter);

} // namespace proveout
