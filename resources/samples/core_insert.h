// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's first case (§5.1): the early stage of roughing the core insert of an injection mould.
#pragma once

#include <string>

namespace proveout::samples {

/// Height of the finished insert over (x, y) in program coordinates, mm; the stock is 140 × 140 × 50 with its
/// lower-left-top corner at the origin.
[[nodiscard]] double coreInsertHeight(double x, double y);

/// The NC program: 255 blocks that move.
[[nodiscard]] std::string coreInsertProgram();

} // namespace proveout::samples
