// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace proveout {

struct LeadBands;
struct LevelProfile;

/// One motion of one convex profile as seen from a tile, in single precision, lengths in mm, heights from the
/// top of the stock. Positions on a straight path are relative to the one nearest to the tile's middle, so
/// that every number is at most as large as the cutter and the tile, and precision does not depend on their
/// position.
struct TilePass {
    enum class Form : std::uint8_t { flat, line, ball, corner, hollow, whole };
    enum class Path : std::uint8_t { straight, round };

    Form form = Form::flat;
    Path path = Path::straight;
    bool level = false; ///< neither rising nor falling anywhere: the nearest position is the lowest

    // Positions of the tile's points, along the path's line and beside it.
    float along = 0; ///< the tile's middle
    float across = 0;
    float alongX = 0; ///< per column
    float acrossX = 0;
    float alongY = 0; ///< per row
    float acrossY = 0;

    // A straight path; for a round one only `z` is used.
    float begin = 0;
    float end = 0;
    float z = 0; ///< of the profile's reference (the centre of its arc, else its lowest point) at 0, or at
                 ///< the middle of a round path
    float slope = 0;
    /// Points over which the cutter is lowest at this place or before it are not under it: they are under its
    /// position at the start, which another motion has cut. -infinity: the start counts too.
    float from = -std::numeric_limits<float>::infinity();

    // The profile.
    float rim2 = 0;   ///< points up to this distance are under the cutter; squares of lengths
    float flatTo = 0; ///< line, corner and hollow: the radius at which the flat ends
    float rise = 0;   ///< line: mm per mm
    float ring = 0;   ///< corner: the radius of its arc's centre
    float radius = 0; ///< ball and corner: of the arc
    float lead = 0; ///< ball: how far ahead it is, by the height of its surface; line: the square of the same
                    ///< by the distance across; negative, and for a hollow as well: the lead is at the rim

    // The arc of a hollow; its chord is the line that bounds it.
    float hollowRing = 0;    ///< the radius of its centre
    float hollowCentre = 0;  ///< the height of its centre above the reference
    float hollowRadius2 = 0; ///< of the arc, squared

    // Lower bounds over a block; see supporting_plane-inl.h.
    float aheadRate = 0; ///< how far ahead the cutter is, roughly: this times √(aheadRadius2 - across²)
    float aheadRadius2 = 0;
    float inner = 0; ///< the profile is nowhere below ρ·√… around `inner` and a line of `rise` to `outer`
    float outer = 0;
    float reach2 = 0; ///< blocks with a middle farther away have no point under the cutter
    float blocksFrom = -std::numeric_limits<float>::infinity(); ///< nor have blocks with a middle before this
    float slack = 0; ///< the error that single precision may add to a bound or subtract from a height

    /// A round path about Z, at most one turn: an arc, a helix, or a level spiral that is nearly an arc.
    /// Positions of the tile are relative to its middle, along and across the direction from the path's
    /// centre to the path's own middle, where angles begin.
    struct Round {
        float middleAlong = 0; ///< the tile's middle, relative to the centre
        float middleAcross = 0;
        float excess = 0;   ///< the square of its distance from the centre, less the square of the path's
                            ///< radius
        float radius = 0;   ///< of the path at its middle
        float widening = 0; ///< change of the radius, mm per radian; level paths only
        float climb = 0;    ///< mm per radian
        float half = 0;     ///< the path extends from minus to plus this angle, radians
        float sine = 0;     ///< of `half`
        float cosine = 0;
        float beginAlong = 0; ///< the path's ends, relative to the tile's middle
        float beginAcross = 0;
        float endAlong = 0;
        float endAcross = 0;
        float lowest = 0;     ///< of the height of the reference
        float spread = 0;     ///< the largest deviation of the radius from `radius`
        float blockReach = 0; ///< from a block's middle to its corners
        float left = 0;       ///< 1 if the outside is to the left of the path, else -1
    };
    Round round;

    const LevelProfile* whole = nullptr; ///< of that form, kept with the motion; never sloped
    const LeadBands* bands =
        nullptr; ///< of leads, kept with the motion; null: each lead is solved, except for hollows
};

} // namespace proveout
