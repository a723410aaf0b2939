// SPDX-License-Identifier: GPL-3.0-or-later
// straight_sweep.h for a row of points at once, in vector code.
#pragma once

#include "core/cutting/profiles/row_points.h"
#include "core/cutting/rows/straight_sweep.h"

namespace proveout {

/// Lowers `out` to the envelope over the points `columns` of a row; `out` is indexed like the row.
void straightRow(const ConvexProfile& profile, const StraightPath& path, const RowPoints& row,
                 Columns columns, float* out);

} // namespace proveout
