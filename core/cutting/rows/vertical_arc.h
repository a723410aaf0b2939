// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs in the planes G18 and G19 that do not drift out of their plane, for flats and balls.
#pragma once

#include "core/cutting/rows/arc_sweep.h"

namespace proveout {

/// Whether verticalArcEnvelope() can solve this profile and path.
[[nodiscard]] bool solvedAsVerticalArc(const ConvexProfile& profile, const ArcPath& path);

/// The lower envelope over `point` of one part of a path, or `known` if that is not lower. Over ground the
/// path is a line, so the candidate places are few and have closed forms; if the radius changes along the
/// arc, the circle of its middle bounds the envelope, and the part is halved until that is within 1e-5 mm.
[[nodiscard]] double verticalArcEnvelope(const ConvexProfile& profile, const ArcPath& path,
                                         const ArcPart& part, const Vec2& point, double known);

} // namespace proveout
