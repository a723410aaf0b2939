// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cutter/cutter.h"

namespace proveout {

/// How far in height, mm, lines may deviate from the arc that they replace. The rest of a micrometre is left
/// to the rounding of cutting.
inline constexpr double kProfileError = 5e-4;
/// Where such an arc is vertical, this much of its radii, mm, counts as its wall.
inline constexpr double kUprightPart = 1e-5;

/// Cutting solves lines, and arcs of the lower half whose centre is not beyond the axis: both are convex. Any
/// other arc becomes as few lines as stay within kProfileError of it.
[[nodiscard]] std::vector<ProfilePiece> solvablePieces(const std::vector<ProfilePiece>& pieces);

} // namespace proveout
