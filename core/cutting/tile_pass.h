// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace proveout {

/// One straight motion of one convex profile seen from a tile, in single precision, lengths in mm, heights
/// from the top of the stock. Places on the path are counted from the one that is nearest to the tile's
/// middle, so that every number is as small as the cutter and the tile, and digits do not depend on where
/// they lie.
struct TilePass {
    enum class Form : std::uint8_t { flat, line, ball, corner };

    Form form = Form::flat;
    bool level = false; ///< nowhere rising or falling: what is nearest is lowest

    // Where the points of the tile lie: along the path's line and beside it.
    float along = 0; ///< the tile's middle
    float across = 0;
    float alongX = 0; ///< per column
    float acrossX = 0;
    float alongY = 0; ///< per row
    float acrossY = 0;

    // The path.
    float begin = 0;
    float end = 0;
    float z = 0; ///< of the profile's reference (the centre of its arc, else its lowest place) at 0
    float slope = 0;

    // The profile.
    float rim2 = 0;   ///< points no farther are under the cutter; squares of lengths
    float flatTo = 0; ///< line and corner: the radius at which the flat ends
    float rise = 0;   ///< line: mm per mm
    float ring = 0;   ///< corner: the radius of its arc's centre
    float radius = 0; ///< ball and corner: of the arc
    float lead = 0; ///< ball: how far ahead it stands, by the height of its surface; line: the square of the
                    ///< same by the distance across; negative: it stands at the rim

    // What bounds it from below over a block; see supporting_plane-inl.h.
    float aheadRate = 0; ///< about how far ahead it stands: that times √(aheadRadius2 - across²)
    float aheadRadius2 = 0;
    float inner = 0; ///< the profile is nowhere below ρ·√… round `inner` and a line of `rise` to `outer`
    float outer = 0;
    float reach2 = 0; ///< middles of blocks that are farther have no point under the cutter
    float slack = 0;  ///< what computing in single precision may add to a bound or take from a height
};

} // namespace proveout
