// SPDX-License-Identifier: GPL-3.0-or-later
// The swept volume of a convex profile along an arc, helix or spiral in any plane.
#pragma once

#include <vector>

#include "core/cutting/profiles/arc_path.h"
#include "core/cutting/rows/straight_sweep.h"

namespace proveout {

/// A part of an arc short enough to be near its chord.
struct ArcPart {
    double middle;
    double half;  ///< it spans t = middle ± half
    double bulge; ///< its largest deviation from its chord
    StraightPath chord;
    Vec2 lo; ///< the box of the tip's path over ground
    Vec2 hi;
    double lowestZ;
};

/// The parts of a path, the lowest first: their results most often make evaluating the others unnecessary.
/// Local coordinates.
[[nodiscard]] std::vector<ArcPart> splitArc(const ArcPath& path);

/// The lower envelope over `point` of one part of a path, or `known` if that is not clearly lower. Any arc,
/// any profile: branch and bound. The tangent at the middle, with a profile wider by the arc's deviation from
/// it, bounds the envelope from below by the exact solution of straight_sweep.h, and the true arc at the
/// place found bounds it from above; the part is halved until the bounds meet within 3e-5 mm.
[[nodiscard]] double arcPartEnvelope(const ConvexProfile& profile, const ArcPath& path, const ArcPart& part,
                                     const Vec2& point, double known);

/// The lower envelope over `point`; +infinity where the cutter never comes.
[[nodiscard]] double arcEnvelope(const ConvexProfile& profile, const ArcPath& path,
                                 const std::vector<ArcPart>& parts, const Vec2& point);

} // namespace proveout
