// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/geometry.h"
#include "core/decimation/lee/region_half_edges.h"

namespace proveout {

/// Distance of a vertex to the average plane of the faces around it, mm: normals and centres of the faces,
/// weighted by their areas (paper §4.2.1, after Schroeder). `hx`, `hy` are the size of a cell.
[[nodiscard]] double averagePlaneDistance(const Star& star, double hx, double hy);

/// Distance of a border vertex to the line through its two neighbours along the border, mm: the same measure
/// within the border. The average plane of a border vertex's half fan cannot replace it: it was measured to
/// open gaps ten times as wide.
[[nodiscard]] double borderLineDistance(const Star& star, double hx, double hy);

/// Distance of the origin to the line through two points of the plane, mm.
[[nodiscard]] double lineDistance(const Vec2& a, const Vec2& b);

} // namespace proveout
