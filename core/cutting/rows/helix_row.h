// SPDX-License-Identifier: GPL-3.0-or-later
// Helices and spirals about Z, in vector code.
#pragma once

#include <cstdint>

#include "core/cutting/profiles/row_points.h"
#include "core/cutting/rows/arc_sweep.h"

namespace proveout {

/// Lowers `out` to the envelope of one part of a path about Z over the points `columns` of a row of at most
/// 64. Returns a bit for each point whose result is not proved; those points are unchanged.
[[nodiscard]] std::uint64_t helixRow(const ConvexProfile& profile, const ArcPath& path, const ArcPart& part,
                                     const RowPoints& row, Columns columns, float* out);

} // namespace proveout
