// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/work_context.h"
#include "core/decimation/solid/solid_frame.h"

namespace proveout {

/// closeSolid() for a surface with walls that comes down to the floor: its triangles on the floor are holes,
/// and the underside is a polygon between their outlines and that of the stock. Where the surface touches the
/// floor without a hole, it is raised by a gap; where holes touch each other, they are set apart by one.
/// `touching`: points of the map where that is not possible because of a wall. The result is nothing then,
/// and if outlines cross. Empty if nothing is left, or if the context was stopped.
[[nodiscard]] std::optional<TriangleMesh> closeCutThrough(const SolidFrame& frame,
                                                          std::vector<LatticeTriangle> surface,
                                                          std::vector<std::uint32_t>& touching,
                                                          const WorkContext& context);

} // namespace proveout
