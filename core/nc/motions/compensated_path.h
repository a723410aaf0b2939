// SPDX-License-Identifier: GPL-3.0-or-later
// Cutter compensation of the motions of a program: how the next one joins the last one.
#pragma once

#include "core/nc/program/motion.h"
#include "core/nc/text/block.h"

namespace proveout {

struct Execution;

/// Appends a motion that a block orders: the path beside it while cutter compensation is on. What is wrong
/// with that is told at `word`.
void appendOrdered(Execution& execution, const Word& word, const Motion& motion);

/// Nothing that follows changes the last motion: compensation ends, or the machine stops.
void finishCompensated(Execution& execution, const Word& word);

} // namespace proveout
