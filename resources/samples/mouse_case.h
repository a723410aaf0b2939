// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's second case (§5.2): rough and finish cutting of the core block for a mouse case.
#pragma once

#include <string>

namespace proveout::samples {

/// Height of the finished core block over (x, y) in program coordinates, mm; the stock is 140 × 100 × 50
/// with its lower-left-top corner at the origin.
[[nodiscard]] double mouseCaseHeight(double x, double y);

/// The NC program: 10 273 blocks that move, the first 2 000 of them roughing.
[[nodiscard]] std::string mouseCaseProgram();

} // namespace proveout::samples
