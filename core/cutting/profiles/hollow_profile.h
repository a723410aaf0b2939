// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/cutting/profiles/convex_profile.h"

namespace proveout {

/// An arc of the upper half of a circle with its inside filled at its own first height: z = centreZ +
/// sqrt(radius² - (centreR - r)²), mm above the tip. Over a point, on a path that falls evenly, it is lowest
/// at one place where it touches, or on its rim, or where the piece before it ends: where that is cut as
/// well, there is nothing to look for on the edge of the flat.
struct HollowProfile {
    ConvexProfile below; ///< its chord, which lies nowhere above it: what bounds are made of
    double centreR;
    double centreZ;
    double radius;
};

/// A cutter with such arcs, cut as they are.
struct HollowedProfiles {
    std::vector<ConvexProfile> convex;
    std::vector<HollowProfile> hollow;
};

/// None of a cutter without hollows, and of one with arcs that are neither hollow nor convex. `rimSlack` as
/// for convexProfiles().
[[nodiscard]] std::optional<HollowedProfiles> hollowedProfiles(const Cutter& cutter, double rimSlack);

} // namespace proveout
