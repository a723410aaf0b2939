// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/nc/geometry/compensation.h"
#include "core/nc/program/motion.h"

namespace proveout {

/// What a block orders for the corner at its end. A value.
struct OrderedCorner {
    bool pending = false;
    bool seen = false;    ///< ordered by the block that is executed now
    bool dwelled = false; ///< the one dwell that may follow did
    bool rounded = false; ///< by ,R, otherwise ,C
    double size = 0;      ///< mm
    bool compensated = false;
    bool across = false; ///< the motion leads out of its plane too
    Plane plane = Plane::xy;
    std::size_t motion = 0; ///< number of the motion before the corner
    std::size_t events = 0; ///< of the program before the corner; those since come behind it
    double feed = 0;        ///< of it
    PlanePath path;         ///< of it, as programmed
};

} // namespace proveout
