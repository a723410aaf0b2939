// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/work_context.h"
#include "core/decimation/solid/solid_frame.h"

namespace proveout {

/// closeSolid() where the surface touches the floor nowhere: two triangles of floor, and each wall one
/// polygon whose lower edge is the floor's, so that walls and floor meet without a vertex in between.
[[nodiscard]] TriangleMesh closeAboveFloor(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                                           const WorkContext& context);

} // namespace proveout
