// SPDX-License-Identifier: GPL-3.0-or-later
// Optional chamfers and corner radii: ,C and ,R of a straight or circular motion, put between it and the
// next. Source: FANUC Series 0i and 30i, operator's manuals for machining centres, optional chamfering and
// corner R.
#pragma once

#include <cstddef>

#include "core/nc/block.h"
#include "core/nc/compensation.h"
#include "core/nc/motion.h"

namespace proveout {

struct Execution;

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

/// Appends a motion that a block orders, and before it what the block before ordered for their corner.
void appendWithCorner(Execution& execution, const Word& word, const Motion& motion);

/// At the end of a block: tells where a corner was ordered that nothing follows.
void checkOrderedCorner(Execution& execution);

} // namespace proveout
