// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/geometry.h"

namespace proveout {

/// G16 of Fanuc's dialect: the word of the first axis of the plane is a radius, that of the second an angle.
struct PolarMode {
    bool on = false;
    Vec3 pole{0};       ///< program coordinates: the zero, or where a radius in G91 began
    double radius = 0;  ///< mm
    double degrees = 0; ///< from the first axis of the plane to the second
};

} // namespace proveout
