// SPDX-License-Identifier: GPL-3.0-or-later
// The swept volume of a convex profile along a straight line.
#pragma once

#include "core/base/geometry.h"
#include "core/cutting/profiles/convex_profile.h"
#include "core/cutting/profiles/row_points.h"

namespace proveout {

/// A straight path of the tip in local coordinates: from `from` over `length` along the unit vector `along`,
/// rising by `slope` per mm of it. A pure plunge has length 0 and is represented by its lower end.
struct StraightPath {
    Vec2 from{0};
    Vec2 along{1, 0};
    double length = 0;
    double z = 0; ///< at `from`
    double slope = 0;
    bool continues = false; ///< what is under the start was cut before, so that it need not be cut again

    [[nodiscard]] double lowest() const { return slope < 0 ? z + slope * length : z; }
};

[[nodiscard]] StraightPath straightPath(const Vec3& start, const Vec3& end);

/// The place on a path whose cutter position reaches lowest over a point.
struct Contact {
    double z;     ///< +infinity where the cutter never comes over the point
    double along; ///< mm from the path's start
};

/// The minimum over the path of z + h(distance): that is convex in the place on the path, so the result is
/// its one stationary place, moved to the nearer end if it is beyond one.
[[nodiscard]] Contact lowestContact(const ConvexProfile& profile, const StraightPath& path,
                                    const Vec2& point);

/// For an endless path that falls by `fall` > 0 per mm: how far ahead of a point, `across` mm beside its
/// line, the cutter is when its surface over the point is lowest. 0 <= across <= rim.
[[nodiscard]] double lead(const ConvexProfile& profile, double fall, double across);

/// The part of the line y = const under a disc of radius `rim` that is moved along the path: one interval, as
/// the swept area is convex.
[[nodiscard]] Span rowSpan(const StraightPath& path, double rim, double y);

} // namespace proveout
