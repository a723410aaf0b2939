// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges of the grid fall so much more than those before them that a wall may cross them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/zmap/rims.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The slope, beyond that of the edge before it, above which an edge may have a wall.
inline constexpr double kWallSlope = 0.25;

/// The largest slope of what is a level beside the rounding of its height, and the least of one that leaves
/// it or comes down to it. The cusps between passes of a ball are as level as that in rare places alone.
inline constexpr double kLevelSlope = 1.0 / 65536;
inline constexpr double kLevelRounding = 2.4e-7; ///< of the height
inline constexpr double kCreaseSlope = kWallSlope / 8;

/// Which of these edges are looked at: all, or only those between parts of the surface that are nearly level,
/// which cost less to find on slopes, or these and those from or to a level.
enum class RimEdges : std::uint8_t { all, betweenLevels, atLevels };

struct FallingEdge {
    RimEdge edge;
    bool reversed; ///< the second point is the higher one
    double high;   ///< heights at both ends, relative to the top of the stock, mm
    double low;
    double fallBefore; ///< of the edge before the high end, in the same direction, mm
    double fallAfter;  ///< of the edge after the low end

    /// Whether it falls by more than a slope over `length`, beyond 0 and beyond the edge before it.
    [[nodiscard]] bool fallsMore(double slope, double length) const {
        return high - low - std::max(fallBefore, 0.0) > slope * length;
    }
    /// Whether it is where a slope begins that was a level before, or ends at one.
    [[nodiscard]] bool isFromLevel(double length) const { return hasCreaseBeside(fallBefore, length); }
    [[nodiscard]] bool isToLevel(double length) const { return hasCreaseBeside(fallAfter, length); }
    [[nodiscard]] bool hasCreaseBeside(double fall, double length) const {
        return high - low > kCreaseSlope * length &&
               std::abs(fall) <= kLevelSlope * length + kLevelRounding * std::abs(low);
    }
};

/// Those of a tile, ascending. An edge may have a wall if it falls by more than kWallSlope times its length
/// beyond 0 and beyond what the edge before it falls in the same direction; edges outside the map fall by 0.
/// The edge after it does not matter: below the rim of a ball, the surface falls more steeply than a low
/// wall. At levels, an edge that comes down to one may be where a wall ends that began before it.
[[nodiscard]] std::vector<FallingEdge> fallingEdges(const ZMapSnapshot& zmap, std::size_t tile,
                                                    RimEdges wanted = RimEdges::all);

} // namespace proveout
