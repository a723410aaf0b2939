// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this library.
#pragma once

#include <vector>

#include "core/decimation/regions/region_mesh.h"
#include "core/decimation/solid/solid_frame.h"

namespace proveout {

/// Points beside a wall that stand on it may leave triangles without an area, or turned over along a round
/// wall: three points of one edge of the wall. Their middle point is given to the triangle beyond their
/// longest side instead. Closed surfaces stay closed; the number of triangles does not change.
void flipWallCaps(const SolidFrame& frame, std::vector<LatticeTriangle>& surface);

} // namespace proveout
