// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/nc/geometry/compensation.h"
#include "core/nc/program/motion.h"

namespace proveout {

/// The corner that a block programs at its end. A value.
struct OrderedCorner {
    bool pending = false;
    bool seen = false;    ///< programmed by the current block
    bool dwelled = false; ///< the one dwell that may follow has come
    bool rounded = false; ///< by ,R, otherwise ,C
    double size = 0;      ///< mm
    bool compensated = false;
    bool across = false; ///< the motion also moves along the normal of its plane
    Plane plane = Plane::xy;
    std::size_t motion = 0; ///< number of the motion before the corner
    std::size_t events = 0; ///< number of events of the program before the corner; later ones come after it
    double feed = 0;        ///< of that motion
    PlanePath path;         ///< of that motion, as programmed
};

} // namespace proveout
