// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/geometry.h"

namespace proveout::samples {

using Polyline = std::vector<Vec3>;

/// Approximates dense polylines by exactly `segments` straight pieces in all, each polyline by one at least
/// (two where it is closed). The pieces are spent where they help most: the piece with the largest deviation
/// is split at the point of that deviation, again and again. Deterministic. `segments` must lie between the
/// least possible number and the number of dense pieces.
[[nodiscard]] std::vector<Polyline> spendSegments(const std::vector<Polyline>& dense, std::size_t segments);

/// How deep the pieces of `coarse` run under `dense` at most, measured vertically at the dense points; for
/// polylines that advance in x, with the same ends.
[[nodiscard]] double depthUnder(const Polyline& dense, const Polyline& coarse);

} // namespace proveout::samples
