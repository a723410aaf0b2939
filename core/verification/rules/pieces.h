// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/zmap/zmap.h"

namespace proveout {

/// A part of the stock that is joined to no other one.
struct Piece {
    double volumeMm3 = 0; ///< each point of the grid counts as a cell around it
    Vec3 place{0};        ///< its first point on the grid, on its surface, program coordinates
};

/// The pieces of a stock: points above its floor that neighbours in a row or a column join. Any thread, and
/// several inside; memory in proportion to the gaps between points in a row.
[[nodiscard]] std::vector<Piece> piecesOf(const ZMapSnapshot& stock);

} // namespace proveout
