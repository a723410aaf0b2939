// SPDX-License-Identifier: GPL-3.0-or-later
// arc_sweep.h for a row of points, by the fastest solver that is proved for each part.
#pragma once

#include <vector>

#include "core/cutting/profiles/row_points.h"
#include "core/cutting/rows/arc_sweep.h"

namespace proveout {

/// Lowers `out` to the envelope over a row of at most 64 points and returns the points that were evaluated.
/// `reach` is at least the profile's rim. Points that the envelope surely leaves at their `heights` may be
/// skipped.
[[nodiscard]] Columns arcRow(const ConvexProfile& profile, const ArcPath& path,
                             const std::vector<ArcPart>& parts, double reach, const RowPoints& row,
                             const float* heights, float* out);

} // namespace proveout
