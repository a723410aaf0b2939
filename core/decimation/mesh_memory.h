// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimation/parameters.h"

namespace proveout {

/// Bytes a point of the grid that meshes take beside the z-map, from the peak memory of runs with and without
/// them: a full mesh has two triangles a point, and is held again, closed, while a file is written.
[[nodiscard]] constexpr double meshBytesPerPoint(const DecimationParameters& parameters, bool full,
                                                 bool solid) {
    constexpr double kSurface = 25;
    constexpr double kFullSolid = 84;
    full = full || parameters.method == DecimationMethod::none || parameters.allowance == 0;
    return full && solid ? kFullSolid : kSurface;
}

} // namespace proveout
