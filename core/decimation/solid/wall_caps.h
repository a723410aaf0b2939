// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/decimation/regions/region_mesh.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Points beside a wall that stand on it may leave triangles without an area, or turned over along a round
/// wall: three points of one edge of the wall. Their middle point is given to the triangle beyond their
/// longest side instead. Closed surfaces stay closed; the number of triangles does not change.
void flipWallCaps(const ZMapSnapshot& zmap, std::vector<LatticeTriangle>& surface);

} // namespace proveout
