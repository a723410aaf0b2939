// SPDX-License-Identifier: GPL-3.0-or-later
// Cutter compensation by vectors, as Fanuc's controls have it, of the motions of a program.
// Source: FANUC Series 0i and 30i, operator's manuals for machining centres, details of cutter compensation.
#pragma once

#include "core/nc/geometry/compensation.h"
#include "core/nc/program/motion.h"
#include "core/nc/text/block.h"

namespace proveout {

struct Execution;

/// Appends the path beside a programmed motion and what joins it to the motion before: into compensation, in
/// it, or out of it. The machine arrives at the programmed end.
void appendByVectors(Execution& execution, const Word& word, const Motion& motion);

/// The control does not know what follows: the tool stays square beside the end of the last motion.
void standSquare(Execution& execution);

/// The last motion, which the control still holds, is this part of what was programmed; the machine stands at
/// the end of it.
void shortenHeld(Execution& execution, const PlanePath& programmed);

/// At the end of a block: whether the control still reads as far as the next motion in the plane.
void countBlock(Execution& execution);

} // namespace proveout
