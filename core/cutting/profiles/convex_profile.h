// SPDX-License-Identifier: GPL-3.0-or-later
// A cutter profile as the minimum of convex ones, each of which the kernels can solve.
#pragma once

#include <vector>

#include "core/cutter/cutter.h"

namespace proveout {

/// Flat at `z0` out to the radius `flatTo`, from there a line or a quarter circle that rises to `rim`; mm
/// above the tip. Convex and never falling outwards, which is all that the solvers rely on. A profile piece
/// over [r0, r1] becomes one of these with its inside filled at its own first height: the true profile is
/// nowhere above, so the minimum over all pieces is the profile itself. Flat, ball, bull-nose and cone are
/// one each.
struct ConvexProfile {
    enum class Side { none, line, arc };

    Side side = Side::none;
    double z0 = 0;
    double flatTo = 0;
    double rim = 0;     ///< the largest radius that counts as under the cutter
    double slope = 0;   ///< line
    double centreR = 0; ///< arc
    double centreZ = 0;
    double radius = 0;

    /// Height at radius `r`, 0 <= r <= rim; a radius past the end of the arc through rounding has the end's
    /// height.
    [[nodiscard]] double height(double r) const;

    /// The height that kernels use as reference: that of the arc's centre, else the lowest.
    [[nodiscard]] double reference() const { return side == Side::arc ? centreZ : z0; }

    /// The same profile with every radius larger by `margin`: nowhere above this one over any point that is
    /// nearer by up to `margin`.
    [[nodiscard]] ConvexProfile dilated(double margin) const;
};

/// The profiles whose minimum is the cutter's; empty for a cutter without pieces. `rimSlack` is added to
/// every rim, so that a point exactly on it is cut in spite of rounding.
[[nodiscard]] std::vector<ConvexProfile> convexProfiles(const Cutter& cutter, double rimSlack);

} // namespace proveout
