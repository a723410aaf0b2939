// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/geometry/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace proveout {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Ends that are one point make a full circle. Between that and a visible distance, the exact geometry
/// decides: a tiny arc or nearly a full circle.
double sweepAbout(const Vec2& centre, const ArcEnds& ends, double samePoint) {
    const Vec2 from = ends.start - centre;
    const Vec2 to = ends.end - centre;
    // One angle instead of a difference of two, so that flat arcs about far centres keep their digits.
    double sweep = std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
    // The sweep leads to the end, wherever within the tolerance the end is.
    if (glm::length(ends.end - ends.start) <= samePoint)
        return sweep + (ends.clockwise ? -kTurn : kTurn);
    if (ends.clockwise && sweep >= 0)
        sweep -= kTurn;
    if (!ends.clockwise && sweep <= 0)
        sweep += kTurn;
    return sweep;
}

} // namespace

ArcTolerances arcTolerances(ArcRule rule, bool inch) {
    constexpr double kMm = 25.4;
    constexpr double kFloat = 1e-5; ///< of grbl, which computes in single precision
    if (rule == ArcRule::grbl)
        return {kFloat, 0.005, 0.001, 0.5};
    if (rule == ArcRule::nist && inch)
        return {0.0002 * kMm, 0.0002 * kMm, 0, 0.0002 * kMm};
    if (rule == ArcRule::nist)
        return {0.002, 0.002, 0, 0.002};
    if (inch)
        return {0.00005 * kMm, 0.00283 * kMm, 0.001, 0.283 * kMm};
    return {0.00127, 0.0283, 0.001, 2.83};
}

tl::expected<Arc, ArcProblem> arcAbout(const Vec2& centre, const ArcEnds& ends,
                                       const ArcTolerances& tolerances) {
    const double startRadius = glm::length(ends.start - centre);
    const double endRadius = glm::length(ends.end - centre);
    if (startRadius < tolerances.radius || endRadius < tolerances.radius)
        return tl::unexpected(ArcProblem{ArcFault::zeroRadius, startRadius, endRadius});
    const double difference = std::abs(startRadius - endRadius);
    const double allowed =
        std::max(tolerances.difference, tolerances.relative * std::max(startRadius, endRadius));
    if (difference > std::min(allowed, tolerances.mostDifference))
        return tl::unexpected(ArcProblem{ArcFault::endsDiffer, startRadius, endRadius});
    return Arc{centre, sweepAbout(centre, ends, tolerances.samePoint)};
}

tl::expected<Arc, ArcProblem> arcOfRadius(double radius, const ArcEnds& ends,
                                          const ArcTolerances& tolerances) {
    if (ends.start == ends.end)
        return tl::unexpected(ArcProblem{ArcFault::fullWithRadius, std::abs(radius), 0});
    const Vec2 chord = ends.end - ends.start;
    const double half = glm::length(chord) / 2;
    const double size = std::abs(radius);
    if (half - size > tolerances.radius)
        return tl::unexpected(ArcProblem{ArcFault::radiusSmall, size, half});
    // The centre is to the left of the chord for a short counter-clockwise arc and a long clockwise one. With
    // a radius that is slightly too short it is on the middle of the chord.
    const double squared = (size - half) * (size + half);
    const double height = squared > 0 ? std::sqrt(squared) : 0.0;
    const bool left = (radius > 0) != ends.clockwise;
    const Vec2 normal = Vec2(-chord.y, chord.x) / (2 * half);
    const Vec2 centre = ends.start + chord / 2.0 + normal * (left ? height : -height);
    if (height == 0)
        return Arc{centre, ends.clockwise ? -kTurn / 2 : kTurn / 2};
    // Computed from the triangle, not from the rounded centre: half the angle over the chord.
    const double angle = 2 * std::atan2(half, height);
    const double sweep = radius > 0 ? angle : kTurn - angle;
    return Arc{centre, ends.clockwise ? -sweep : sweep};
}

double sagitta(double radius, double sweep) {
    const double quarter = std::sin(sweep / 4);
    return 2 * radius * quarter * quarter;
}

} // namespace proveout
