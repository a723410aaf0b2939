// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry of G2 and G3 in their plane. Lengths in mm; pure functions.
#pragma once

#include <cstdint>

#include <tl/expected.hpp>

#include "core/base/geometry.h"
#include "core/nc/text/dialect.h"

namespace proveout {

/// The permitted inaccuracy of an arc. Sources: LinuxCNC, whose limits are round numbers in the unit of the
/// program; grbl; the RS274/NGC interpreter of NIST, version 3.
struct ArcTolerances {
    double radius;           ///< a smaller radius is invalid; R may be short by this much
    double difference;       ///< between the radii at both ends: always allowed
    double relative;         ///< relative to the larger radius: allowed beyond that …
    double mostDifference;   ///< … up to this much
    double samePoint = 5e-9; ///< ends closer than this count as one: the rounding that adding up increments
                             ///< may leave
};
[[nodiscard]] ArcTolerances arcTolerances(ArcRule rule, bool inch);

enum class ArcFault : std::uint8_t { zeroRadius, endsDiffer, fullWithRadius, radiusSmall };

/// Why there is no arc, with the lengths involved.
struct ArcProblem {
    ArcFault fault;
    double startRadius = 0; ///< radiusSmall: the given radius
    double endRadius = 0;   ///< radiusSmall: half the distance of the ends
};

struct Arc {
    Vec2 centre;
    double sweep; ///< signed, counter-clockwise positive, up to a full turn
};

/// The ends of an arc and its direction.
struct ArcEnds {
    Vec2 start;
    Vec2 end;
    bool clockwise;
};

/// The arc about a centre. Ends that coincide make a full circle.
[[nodiscard]] tl::expected<Arc, ArcProblem> arcAbout(const Vec2& centre, const ArcEnds& ends,
                                                     const ArcTolerances& tolerances);

/// The arc with a given radius; a negative one sweeps more than half a turn.
[[nodiscard]] tl::expected<Arc, ArcProblem> arcOfRadius(double radius, const ArcEnds& ends,
                                                        const ArcTolerances& tolerances);

/// Height of the arc over its chord, for less than half a turn.
[[nodiscard]] double sagitta(double radius, double sweep);

} // namespace proveout
