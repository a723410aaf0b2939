// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/work_context.h"
#include "core/decimation/regions/region_mesh.h"
#include "core/decimation/solid/solid_frame.h"

namespace proveout {

/// Walls are nearer to where they stand than the surface to its points.
inline constexpr double kWallShare = 0.2;

/// Removes points beside walls that the wall does not need, so that its faces become few and long: every
/// point that was removed is within kWallShare · `allowance` of the surface, and every other point of the map
/// as near to it as before, or within the allowance, vertically. `surface` covers the map; it has the points
/// beside walls as vertices, and stays closed. `allowance`: mm, above 0. A stopped context leaves the rest as
/// it is.
void simplifyWalls(const SolidFrame& frame, double allowance, std::vector<LatticeTriangle>& surface,
                   const WorkContext& context = {});

} // namespace proveout
