// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this library.
#pragma once

#include <vector>

#include "core/decimation/regions/region_mesh.h"
#include "core/decimation/solid/solid_frame.h"
#include "core/decimation/solid/wall_caps.h"

namespace proveout {

/// A point beside a wall that stands on it may leave a level folded beside it: a triangle that it has moved
/// out of is turned over, and covers others. The triangles around such a fold are replaced by others of the
/// same points. What cannot be unfolded stays. As after flipWallCaps(), closed surfaces stay closed, and the
/// number of triangles does not change.
FormerTriangles unfoldLevels(const SolidFrame& frame, std::vector<LatticeTriangle>& surface);

} // namespace proveout
