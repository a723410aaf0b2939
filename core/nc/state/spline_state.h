// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/nc/geometry/spline.h"

namespace proveout {

/// What a spline passes on to the next block. Program coordinates in mm.
struct SplineState {
    /// From the start of the next cubic spline to its second control point, so that it continues smoothly;
    /// valid while the program has `handleAt` motions.
    Vec2 handle{0};
    std::size_t handleAt = SIZE_MAX;

    /// The points of the open NURBS block; empty if there is none.
    Spline nurbs;
    Vec3 nurbsEnd{0}; ///< machine coordinates
    std::uint8_t nurbsEndKnown = 0;
};

} // namespace proveout
