// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/work_context.h"
#include "core/decimation/solid/solid_frame.h"

namespace proveout {

/// closeSolid() where the surface touches the floor: triangles wholly on the floor are holes, and the floor
/// repeats the triangles that are left. Empty where none is.
[[nodiscard]] TriangleMesh closeOnFloor(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                                        const WorkContext& context);

} // namespace proveout
