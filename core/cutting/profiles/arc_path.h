// SPDX-License-Identifier: GPL-3.0-or-later
// The path of an arc, helix or spiral in any plane, with the derivatives that the solvers need.
#pragma once

#include "core/base/geometry.h"
#include "core/nc/program/motion.h"

namespace proveout {

/// p(t) for t in [begin, end], a part of [0, 1]: around `centre` in the plane of the axes `first` and
/// `second`, with a radius that changes linearly from `radius` by `widening`, and moving linearly along
/// `normal`. Local coordinates.
struct ArcPath {
    int first = 0;
    int second = 1;
    int normal = 2;
    Vec3 centre{0}; ///< its normal component is that of the path at t = 0
    double radius = 0;
    double widening = 0;
    double angle = 0; ///< at t = 0
    double sweep = 0;
    double climb = 0; ///< along the normal
    double begin = 0;
    double end = 1;

    [[nodiscard]] Vec3 at(double t) const;
    struct Tangent {
        Vec3 place;
        Vec3 rate; ///< its change per unit of t
    };
    [[nodiscard]] Tangent tangentAt(double t) const;
    /// A bound of |p''| over the path.
    [[nodiscard]] double bend() const;
    /// The distance of a point from the path over ground, positive to the left of it; for a spiral, from the
    /// nearest turn; if the plane of the arc is vertical, from its chord.
    [[nodiscard]] double beside(const Vec2& point) const;
    /// The distance over ground of a point from the path, which must be a levelCircle().
    [[nodiscard]] double distanceToCircle(const Vec2& point) const;
    /// Whether the tip moves on one circle at one height.
    [[nodiscard]] bool levelCircle() const;
};

/// The path of an arc with `origin` as the origin of its coordinates. If several turns pass over the same
/// circle, only the lowest one is kept: it reaches below all others.
[[nodiscard]] ArcPath arcPath(const Motion& motion, const Vec3& origin);

} // namespace proveout
