// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/work_context.h"
#include "core/decimation/solid/solid_frame.h"

namespace proveout {

/// closeSolid() for a surface that does not touch the floor anywhere: two triangles of floor, and each wall
/// is one polygon whose lower edge is the floor's, so that walls and floor meet without a vertex in between.
[[nodiscard]] TriangleMesh closeAboveFloor(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                                           const WorkContext& context);

} // namespace proveout
