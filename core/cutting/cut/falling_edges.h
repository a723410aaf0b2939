// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges of the grid fall so much more than those before them that a wall may cross them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/zmap/rims.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The slope, beyond that of the edge before it, above which an edge may have a wall.
inline constexpr double kWallSlope = 0.25;

/// Which of these edges are looked at: all, or only those between parts of the surface that are nearly level,
/// which cost less to find on slopes.
enum class RimEdges : std::uint8_t { all, betweenLevels };

struct FallingEdge {
    RimEdge edge;
    bool reversed; ///< the second point is the higher one
    double high;   ///< heights at both ends, relative to the top of the stock, mm
    double low;
    double fallBefore; ///< of the edge before the high end, in the same direction, mm
};

/// Those of a tile, ascending. An edge may have a wall if it falls by more than kWallSlope times its length
/// beyond 0 and beyond what the edge before it falls in the same direction; edges outside the map fall by 0.
/// The edge after it does not matter: below the rim of a ball, the surface falls more steeply than a low
/// wall.
[[nodiscard]] std::vector<FallingEdge> fallingEdges(const ZMapSnapshot& zmap, std::size_t tile,
                                                    RimEdges wanted = RimEdges::all);

} // namespace proveout
