// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/geometry.h"

namespace proveout {

struct Execution;

/// G16 of Fanuc's dialect: the word of the first axis of the plane is a radius, that of the second an angle.
struct PolarMode {
    bool on = false;
    Vec3 pole{0};       ///< program coordinates: the zero, or where a radius in G91 began
    double radius = 0;  ///< mm
    double degrees = 0; ///< from the first axis of the plane to the second
};

/// Puts the point that the words of the plane give into `program`; the AxisBits of what they set. `known`:
/// AxisBits of `program`. A radius that counts from an unknown place is told.
std::uint8_t readPolarWords(Execution& execution, std::uint8_t known, Vec3& program);

} // namespace proveout
