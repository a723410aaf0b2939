// SPDX-License-Identifier: GPL-3.0-or-later
// Cutter compensation of the motions of a program: how the next motion joins the previous one. The row of the
// dialect selects one of two methods.
#pragma once

#include "core/nc/geometry/compensation.h"
#include "core/nc/program/motion.h"
#include "core/nc/text/block.h"

namespace proveout {

struct Execution;

/// Appends the motion of a block: its offset path while cutter compensation is on. Errors are reported at
/// `word`.
void appendOrdered(Execution& execution, const Word& word, const Motion& motion);

/// Nothing that follows changes the last motion: compensation ends, or the machine stops.
void finishCompensated(Execution& execution, const Word& word);

/// By vectors: the last motion, whose end may still change, is this part of what was programmed; the machine
/// is at the end of it.
void shortenHeld(Execution& execution, const PlanePath& programmed);

/// By vectors, at the end of a block: checks whether the look-ahead still extends to the next motion in the
/// plane.
void countBlock(Execution& execution);

} // namespace proveout
