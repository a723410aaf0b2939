// SPDX-License-Identifier: GPL-3.0-or-later
// A cutter that moves around a circle at one height: the nearest place of the path is the lowest.
#pragma once

#include "core/cutting/profiles/arc_path.h"
#include "core/cutting/profiles/convex_profile.h"
#include "core/cutting/profiles/row_points.h"

namespace proveout {

/// Lowers `out` to the envelope over the points `columns` of a row; `out` is indexed like the row. The path
/// must be a levelCircle().
void circleRow(const ConvexProfile& profile, const ArcPath& path, const RowPoints& row, Columns columns,
               float* out);

} // namespace proveout
