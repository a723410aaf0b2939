// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/cutter/cutter.h"
#include "core/cutting/profiles/convex_profile.h"

namespace proveout {

/// A whole profile, in single precision, for motions at one height: there the cutter is lowest where it is
/// nearest, for any shape, so that pieces need not be convex or cut one by one.
struct LevelProfile {
    /// Over the radii from the end of the piece before: `z0` and a line of `rise` from `r0`, or `centreZ` and
    /// `side` times the root of radius2 - (r - centreR)².
    struct Piece {
        float rim2; ///< of its end, squared; radii that rounding moves beyond it still count
        bool arc;
        float r0;
        float z0;
        float rise;
        float centreR;
        float centreZ;
        float radius2;
        float side;
    };

    std::vector<Piece> pieces; ///< from the axis outwards; heights relative to the first
    std::vector<ProfilePiece> exact;
    double rim;
    ConvexProfile below; ///< nowhere above the profile; bounds are made from it

    /// `pieces`: at least one. `rimSlack` is added to the last rim.
    LevelProfile(std::span<const ProfilePiece> pieces, double rimSlack);

    /// Height above the tip; +infinity beyond the rim.
    [[nodiscard]] double height(double radius) const;
};

} // namespace proveout
