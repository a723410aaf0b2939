// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/cutting/profiles/convex_profile.h"

namespace proveout {

/// An arc of the upper half of a circle with its inside filled at its own first height: z = centreZ +
/// sqrt(radius² - (centreR - r)²), mm above the tip. Over a point, on a path that falls evenly, it is lowest
/// at the one place where it touches, or on its rim, or at the edge of its flat; if the piece before it is
/// cut as well, that edge need not be examined.
struct HollowProfile {
    ConvexProfile below; ///< its chord, which is nowhere above it and from which bounds are made
    double centreR;
    double centreZ;
    double radius;
};

/// A cutter with such arcs, which are cut without replacing them by lines.
struct HollowedProfiles {
    std::vector<ConvexProfile> convex;
    std::vector<HollowProfile> hollow;
};

/// Nothing for a cutter without hollows, and for one with arcs that are neither hollow nor convex. `rimSlack`
/// as for convexProfiles().
[[nodiscard]] std::optional<HollowedProfiles> hollowedProfiles(const Cutter& cutter, double rimSlack);

} // namespace proveout
