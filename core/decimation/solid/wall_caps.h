// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this library.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/decimation/regions/region_mesh.h"
#include "core/decimation/solid/solid_frame.h"

namespace proveout {

/// Triangles that were changed, and what they were, in this order.
using FormerTriangles = std::vector<std::pair<std::size_t, LatticeTriangle>>;

/// Points beside a wall that stand on it may leave triangles without an area, or turned over: three points of
/// one edge of the wall, or a long triangle that a point has moved out of. They are exchanged, with the
/// triangle beyond one of their sides, for the two others of the same four points. So are those that cut off
/// a corner of a wall. Closed surfaces stay closed; the number of triangles does not change.
FormerTriangles flipWallCaps(const SolidFrame& frame, std::vector<LatticeTriangle>& surface);

} // namespace proveout
