// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/cutter/cutter.h"
#include "core/cutting/profiles/convex_profile.h"

namespace proveout {

/// A whole profile, in single precision, for motions at one height: there the cutter is lowest where it is
/// nearest whatever its shape, so that no piece need be convex, nor be cut on its own.
struct LevelProfile {
    /// Over the radii from the end of the one before: `z0` and a line of `rise` from `r0`, or `centreZ` and
    /// `side` times the root of radius2 - (r - centreR)².
    struct Piece {
        float rim2; ///< of its end, squared; what rounds beyond it still counts
        bool arc;
        float r0;
        float z0;
        float rise;
        float centreR;
        float centreZ;
        float radius2;
        float side;
    };

    std::vector<Piece> pieces; ///< from the axis outwards; heights above the first
    std::vector<ProfilePiece> exact;
    double rim;
    ConvexProfile below; ///< nowhere above the profile: what bounds are made of

    /// `pieces`: at least one. `rimSlack` is added to the last rim.
    LevelProfile(std::span<const ProfilePiece> pieces, double rimSlack);

    /// Above the tip; +infinity beyond the rim.
    [[nodiscard]] double height(double radius) const;
};

} // namespace proveout
