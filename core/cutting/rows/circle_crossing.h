// SPDX-License-Identifier: GPL-3.0-or-later
// Where a line over ground comes under a cutter on a circle or helix about Z: in closed form.
#pragma once

#include "core/cutting/profiles/arc_path.h"
#include "core/cutting/rows/edge_crossing.h"

namespace proveout {

/// Whether the tip moves on one circle, seen from above; then ArcPath::distanceToCircle() is its distance
/// over ground.
[[nodiscard]] inline bool isRoundOverGround(const ArcPath& path) {
    return path.normal == 2 && path.widening == 0;
}

/// The place of such a path that is nearest to a point over ground; of several turns, the lowest.
[[nodiscard]] Vec3 nearestPlace(const ArcPath& path, const Vec2& point);

struct CircleEntry {
    EdgeCrossing crossing;
    double height = 0; ///< the cutter is at least as low there
};

/// Where a line first comes under a disc of the profile's rim on a path that isRoundOverGround(). `beyond`:
/// how far beyond its end, mm. Places after `latest` may be left out.
[[nodiscard]] CircleEntry entryUnderCircle(const ConvexProfile& profile, const ArcPath& path,
                                           const EdgeLine& line, double beyond, double latest);

} // namespace proveout
