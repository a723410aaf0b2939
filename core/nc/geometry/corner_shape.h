// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry of optional chamfers and corner radii inserted between two paths. In one plane, lengths in mm;
// pure functions. `before` ends where `after` begins. Source: FANUC Series 0i and 30i, operator's manuals for
// machining centres, optional chamfering and corner R.
#pragma once

#include <optional>

#include "core/nc/geometry/compensation.h"

namespace proveout {

/// Whether the paths meet within a degree of straight, so that nothing is inserted between them.
[[nodiscard]] bool needsNoCorner(const PlanePath& before, const PlanePath& after);

/// The straight path between the points at `length` from the corner, measured in a straight line. Nothing if
/// a path is shorter.
[[nodiscard]] std::optional<PlanePath> chamferBetween(const PlanePath& before, const PlanePath& after,
                                                      double length);

/// The arc of a radius that touches both paths. Nothing if it would touch them beyond their ends.
[[nodiscard]] std::optional<PlanePath> roundingBetween(const PlanePath& before, const PlanePath& after,
                                                       double radius);

/// The path up to a point of it, and the path from that point on.
[[nodiscard]] PlanePath upTo(const PlanePath& path, const Vec2& point);
[[nodiscard]] PlanePath fromOn(const PlanePath& path, const Vec2& point);

} // namespace proveout
