// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "resources/samples/block_budget.h"
#include "resources/samples/height_map.h"

namespace proveout::samples {

/// The closed contours of `map` at `level`, by marching squares: each with what is higher on its right (so
/// that a right-handed cutter climb-mills it), first point = last point = its point of greatest x, at
/// z = `level`. Contours that leave the map are left out.
[[nodiscard]] std::vector<Polyline> contours(const HeightMap& map, double level);

} // namespace proveout::samples
