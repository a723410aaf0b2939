// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the stock is where the program cuts: a misplaced stock must be reported.
#pragma once

#include "core/base/diagnostic.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

/// Known before anything is cut, from the box of the motions at feed: a warning if they never reach the
/// stock, or extend beyond it by at least its size, and by more than the width of their largest cutter.
/// Nothing while tools are missing.
[[nodiscard]] Diagnostics misplacedStock(const Program& program, const Setup& setup, const ToolChoice& tools);

/// The same message about a program that was run to its end and has removed nothing, although its box reaches
/// the stock.
[[nodiscard]] Diagnostics untouchedStock(const Program& program, const Setup& setup, const ToolChoice& tools);

} // namespace proveout
