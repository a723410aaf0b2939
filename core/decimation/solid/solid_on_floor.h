// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/work_context.h"
#include "core/decimation/solid/solid_frame.h"

namespace proveout {

/// closeSolid() for a surface that touches the floor: triangles entirely on the floor are holes, and the
/// floor repeats the remaining triangles. Empty if there are none.
[[nodiscard]] TriangleMesh closeOnFloor(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                                        const WorkContext& context);

} // namespace proveout
