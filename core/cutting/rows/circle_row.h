// SPDX-License-Identifier: GPL-3.0-or-later
// A cutter that goes round a circle at one height: the nearest place of the path is the lowest.
#pragma once

#include "core/cutting/profiles/arc_path.h"
#include "core/cutting/profiles/convex_profile.h"
#include "core/cutting/profiles/row_points.h"

namespace proveout {

/// Lowers `out` to the envelope over the points `columns` of a row; `out` is indexed as the row is. The path
/// fulfils levelCircle().
void circleRow(const ConvexProfile& profile, const ArcPath& path, const RowPoints& row, Columns columns,
               float* out);

} // namespace proveout
