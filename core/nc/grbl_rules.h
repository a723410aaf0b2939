// SPDX-License-Identifier: GPL-3.0-or-later
// What grbl checks before a block runs, and what it answers. Source: grbl 1.1, gcode.c, error codes.
#pragma once

#include "core/nc/messages.h"

namespace proveout {

struct Execution;

/// Whether grbl runs the block. It drops a block as a whole where anything in it is wrong, which is told.
[[nodiscard]] bool mayRunOnGrbl(Execution& execution);

/// The error code by which grbl answers what a message is about, with the remedy; null where there is none. A
/// literal marked with PROVEOUT_TEXT.
[[nodiscard]] const char* answerOfGrbl(const Message& message);

} // namespace proveout
