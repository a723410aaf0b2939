// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/program/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace proveout {

namespace {

constexpr double kPi = std::numbers::pi;

/// The values of an arc for the formulas below: a radius that changes linearly from `startRadius` by
/// `radiusGrowth`.
struct Spiral {
    PlaneAxes plane;
    Vec2 spoke; ///< from the centre to the start point
    double startRadius;
    double radiusGrowth;

    explicit Spiral(const Motion& motion)
        : plane(axes(motion.plane)), spoke(inPlane(motion.start, plane) - inPlane(motion.centre, plane)),
          startRadius(glm::length(spoke)),
          radiusGrowth(glm::length(inPlane(motion.end, plane) - inPlane(motion.centre, plane)) -
                       startRadius) {}
};

/// Adds the points of the arc that are farthest in the direction of the angle `quadrant` (about the plane's
/// normal), if the arc passes there. With a growing radius they are slightly off the quadrant: where the
/// derivative of r(t)·cos vanishes, found by fixed-point iteration, since the growth is small.
void addExtreme(Box3& box, const Motion& motion, const Spiral& spiral, double quadrant, double startAngle) {
    double angle = quadrant;
    double t = 0;
    for (int i = 0; i < 6; ++i) {
        t = (angle - startAngle) / motion.sweep;
        const double radius = spiral.startRadius + spiral.radiusGrowth * std::clamp(t, 0.0, 1.0);
        angle = quadrant + std::atan(spiral.radiusGrowth / (radius * motion.sweep));
    }
    t = (angle - startAngle) / motion.sweep;
    if (t > 0 && t < 1)
        box.add(pointAt(motion, t));
}

} // namespace

PlaneAxes axes(Plane plane) {
    switch (plane) {
    case Plane::xy:
        return {0, 1, 2};
    case Plane::zx:
        return {2, 0, 1};
    case Plane::yz:
        return {1, 2, 0};
    }
    return {0, 1, 2};
}

Vec2 inPlane(const Vec3& point, const PlaneAxes& plane) {
    return {point[plane.first], point[plane.second]};
}

Vec3 withPlane(Vec3 point, const Vec2& place, const PlaneAxes& plane) {
    point[plane.first] = place.x;
    point[plane.second] = place.y;
    return point;
}

double arcRadius(const Motion& motion) {
    return Spiral(motion).startRadius;
}

Vec3 pointAt(const Motion& motion, double t) {
    if (t >= 1)
        return motion.end;
    if (t <= 0)
        return motion.start;
    Vec3 point = motion.start + (motion.end - motion.start) * t;
    if (motion.kind != MotionKind::arc)
        return point;
    const Spiral spiral(motion);
    if (spiral.startRadius == 0)
        return point;
    // Rotating the first spoke keeps the precision that an angle from atan2 would lose on large arcs.
    const double scale = (spiral.startRadius + spiral.radiusGrowth * t) / spiral.startRadius;
    const double cosine = std::cos(motion.sweep * t) * scale;
    const double sine = std::sin(motion.sweep * t) * scale;
    point[spiral.plane.first] =
        motion.centre[spiral.plane.first] + spiral.spoke.x * cosine - spiral.spoke.y * sine;
    point[spiral.plane.second] =
        motion.centre[spiral.plane.second] + spiral.spoke.x * sine + spiral.spoke.y * cosine;
    return point;
}

double pathLength(const Motion& motion) {
    if (motion.kind != MotionKind::arc)
        return glm::length(motion.end - motion.start);
    const Spiral spiral(motion);
    const double along = motion.end[spiral.plane.normal] - motion.start[spiral.plane.normal];
    const double straight = along * along + spiral.radiusGrowth * spiral.radiusGrowth;
    // Gauss-Legendre with five points: the speed is nearly constant, so this is exact to rounding.
    constexpr std::array<double, 5> kNodes{-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
                                           0.9061798459386640};
    constexpr std::array<double, 5> kWeights{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                             0.4786286704993665, 0.2369268850561891};
    double length = 0;
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
        const double radius = spiral.startRadius + spiral.radiusGrowth * (kNodes[i] + 1) / 2;
        const double around = radius * motion.sweep;
        length += kWeights[i] / 2 * std::sqrt(around * around + straight);
    }
    return length;
}

bool withinLimits(const Motion& motion) {
    if (motion.kind != MotionKind::arc)
        return true;
    constexpr double kMostRadians = 2 * kPi * kMostTurns * (1 + 1e-12);
    return std::abs(motion.sweep) <= kMostRadians && pathLength(motion) <= kLongestArc;
}

Box3 bounds(const Motion& motion) {
    Box3 box;
    box.add(motion.start);
    box.add(motion.end);
    if (motion.kind != MotionKind::arc || motion.sweep == 0)
        return box;
    const Spiral spiral(motion);
    if (spiral.startRadius == 0)
        return box;
    const double startAngle = std::atan2(spiral.spoke.y, spiral.spoke.x);
    const double turn = std::copysign(2 * kPi, motion.sweep);
    // The radius only grows or only shrinks, so that the extremes are in the first or in the last turn.
    const double lastTurn = std::abs(motion.sweep) > 2 * kPi ? startAngle + motion.sweep - turn : startAngle;
    for (const double from : {startAngle, lastTurn}) {
        const double firstQuadrant = std::floor(std::min(from, from + turn) / (kPi / 2));
        for (int k = 0; k <= 5; ++k)
            addExtreme(box, motion, spiral, (firstQuadrant + k) * (kPi / 2), startAngle);
        if (lastTurn == startAngle)
            break;
    }
    return box;
}

} // namespace proveout
