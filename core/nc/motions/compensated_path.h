// SPDX-License-Identifier: GPL-3.0-or-later
// Cutter compensation of the motions of a program: how the next one joins the last one. The row of the
// dialect says in which of the two ways.
#pragma once

#include "core/nc/geometry/compensation.h"
#include "core/nc/program/motion.h"
#include "core/nc/text/block.h"

namespace proveout {

struct Execution;

/// Appends the motion of a block: the path beside it while cutter compensation is on. What is wrong with that
/// is reported at `word`.
void appendOrdered(Execution& execution, const Word& word, const Motion& motion);

/// Nothing that follows changes the last motion: compensation ends, or the machine stops.
void finishCompensated(Execution& execution, const Word& word);

/// By vectors: the last motion, whose end may still change, is this part of what was programmed; the machine
/// is at the end of it.
void shortenHeld(Execution& execution, const PlanePath& programmed);

/// By vectors, at the end of a block: whether the control still reads as far as the next motion in the plane.
void countBlock(Execution& execution);

} // namespace proveout
