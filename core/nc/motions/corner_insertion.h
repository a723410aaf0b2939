// SPDX-License-Identifier: GPL-3.0-or-later
// Optional chamfers and corner radii: ,C and ,R of a straight or circular motion, inserted between it and the
// next. Source: FANUC Series 0i and 30i, operator's manuals for machining centres, optional chamfering and
// corner R.
#pragma once

#include "core/nc/program/motion.h"
#include "core/nc/text/block.h"

namespace proveout {

struct Execution;

/// Appends the motion of a block, preceded by the corner that the previous block programmed.
void appendWithCorner(Execution& execution, const Word& word, const Motion& motion);

/// At the end of a block: reports a programmed corner that no motion follows.
void checkOrderedCorner(Execution& execution);

} // namespace proveout
