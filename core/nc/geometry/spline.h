// SPDX-License-Identifier: GPL-3.0-or-later
// Splines as straight lines: the geometry of G5, G5.1 and the NURBS block, in a plane. Pure, any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

/// The largest number of straight motions of one spline.
inline constexpr std::size_t kMostSplinePoints = 100'000;
/// The order of a spline is its degree plus one. The work of LinuxCNC's own evaluation doubles with each.
inline constexpr int kLeastSplineOrder = 3;
inline constexpr int kMostSplineOrder = 16;

struct ControlPoint {
    Vec2 at{0};
    double weight = 1; ///< greater than 0
};

/// A clamped B-spline on LinuxCNC's knots 0 … 0, 1, 2 … m … m, where each end is repeated `order` times: it
/// begins in the first control point and ends in the last. With `order` points it is one Bézier curve.
struct Spline {
    std::vector<ControlPoint> points; ///< at least `order` of them
    int order = kLeastSplineOrder;
};

/// The points of a polyline within `chordError` of the spline, from the second one on; the last is the last
/// control point to the last bit. Nothing if it would have more than kMostSplinePoints. Source: knot
/// insertion by polar forms (Ramshaw), subdivision of rational Bézier curves until their control points, and
/// so the curve within their hull, are close to their chord.
[[nodiscard]] std::optional<std::vector<Vec2>> flattened(const Spline& spline, double chordError);

} // namespace proveout
