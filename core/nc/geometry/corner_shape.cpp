// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/geometry/corner_shape.h"

#include <cmath>
#include <numbers>

#include "core/nc/geometry/corner_vectors.h"

namespace proveout {

namespace {

constexpr double kStraightOn = std::numbers::pi / 180;
/// Tolerance for the rounding of path lengths, in mm.
constexpr double kRounding = 1e-9;

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

double angleFrom(const Vec2& a, const Vec2& b) {
    return std::atan2(cross(a, b), glm::dot(a, b));
}

double turnBetween(const PlanePath& before, const PlanePath& after) {
    return angleFrom(headingAtEnd(before), headingAtStart(after));
}

Vec2 turned(const Vec2& v, double angle) {
    return {v.x * std::cos(angle) - v.y * std::sin(angle), v.x * std::sin(angle) + v.y * std::cos(angle)};
}

/// The point at `length` from `corner` on a path that leaves it with `heading`; nothing if the path is
/// shorter.
std::optional<Vec2> pointAtDistance(const PlanePath& path, const Vec2& corner, const Vec2& heading,
                                    double length) {
    if (!path.arc()) {
        if (length > glm::distance(path.start, path.end) + kRounding)
            return {};
        return corner + heading * length;
    }
    const Vec2 spoke = corner - path.centre;
    const double radius = glm::length(spoke);
    if (length > 2 * radius)
        return {};
    const double angle = 2 * std::asin(length / (2 * radius));
    if (angle > std::abs(path.sweep) + kRounding / radius)
        return {};
    return path.centre + turned(spoke, std::copysign(angle, cross(spoke, heading)));
}

/// The point of a path's line or circle nearest to the centre of an arc that touches it.
Vec2 touching(const PlanePath& path, const Vec2& centre) {
    if (path.arc())
        return path.centre + glm::normalize(centre - path.centre) * glm::distance(path.start, path.centre);
    const Vec2 along = glm::normalize(path.end - path.start);
    return path.start + along * glm::dot(centre - path.start, along);
}

/// Whether a point on the line or circle of a path is on the path itself.
bool liesOn(const PlanePath& path, const Vec2& point) {
    if (path.arc()) {
        const double sense = std::copysign(1.0, path.sweep);
        const double rounding = kRounding / glm::distance(path.start, path.centre);
        return sense * fromOn(path, point).sweep >= -rounding && sense * upTo(path, point).sweep >= -rounding;
    }
    const Vec2 along = glm::normalize(path.end - path.start);
    return glm::dot(point - path.start, along) >= -kRounding &&
           glm::dot(path.end - point, along) >= -kRounding;
}

} // namespace

bool needsNoCorner(const PlanePath& before, const PlanePath& after) {
    return std::abs(turnBetween(before, after)) <= kStraightOn;
}

std::optional<PlanePath> chamferBetween(const PlanePath& before, const PlanePath& after, double length) {
    const auto start = pointAtDistance(before, before.end, -headingAtEnd(before), length);
    const auto end = pointAtDistance(after, after.start, headingAtStart(after), length);
    if (!start || !end)
        return {};
    return PlanePath{*start, *end, Vec2(0), 0};
}

std::optional<PlanePath> roundingBetween(const PlanePath& before, const PlanePath& after, double radius) {
    // The centre is the position of a tool with that radius in the corner.
    const double side = std::copysign(1.0, turnBetween(before, after));
    const double offset = side * radius;
    if (!offsetPath(before, offset) || !offsetPath(after, offset))
        return {};
    const auto corner = cornerPoints(before, after, offset);
    if (!corner || corner->all().size() != 1)
        return {};
    const Vec2 centre = corner->first();
    const Vec2 start = touching(before, centre);
    const Vec2 end = touching(after, centre);
    if (!liesOn(before, start) || !liesOn(after, end))
        return {};
    const double sweep = angleFrom(start - centre, end - centre);
    return PlanePath{start, end, centre,
                     side * (side * sweep > 0 ? side * sweep : side * sweep + 2 * std::numbers::pi)};
}

PlanePath upTo(const PlanePath& path, const Vec2& point) {
    PlanePath result = path;
    result.end = point;
    result.sweep = path.arc() ? trimmedSweep(path, path.start, point) : 0;
    return result;
}

PlanePath fromOn(const PlanePath& path, const Vec2& point) {
    PlanePath result = path;
    result.start = point;
    result.sweep = path.arc() ? trimmedSweep(path, point, path.end) : 0;
    return result;
}

} // namespace proveout
