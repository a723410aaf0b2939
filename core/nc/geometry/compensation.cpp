// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/geometry/compensation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace proveout {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTurn = 2 * kPi;
/// Nothing is inserted at corners flatter than this.
constexpr double kFlatCorner = 0.05;
/// The headings of an arc with a smaller radius cannot be computed.
constexpr double kLeastRadius = 1e-6;
/// In turns: an arc of exactly one turn must not count as more than one.
constexpr double kTurnRounding = 1e-9;

Vec2 leftOf(const Vec2& heading) {
    return {-heading.y, heading.x};
}

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

Vec2 headingAt(const PlanePath& arc, const Vec2& point) {
    return leftOf(glm::normalize(point - arc.centre)) * std::copysign(1.0, arc.sweep);
}

/// The number of full turns of an arc before its last one.
double fullTurns(double sweep) {
    return std::max(0.0, std::ceil(std::abs(sweep) / kTurn - kTurnRounding) - 1);
}

/// If the radius at its ends differs, the one at its end counts.
double arcRadius(const PlanePath& arc) {
    return glm::distance(arc.end, arc.centre);
}

/// How far the start of an arc is inside the circle that counts. LinuxCNC first moves it out to that circle.
Vec2 slip(const PlanePath& arc) {
    const Vec2 spoke = arc.centre - arc.start;
    return glm::normalize(spoke) * (arcRadius(arc) - glm::length(spoke));
}

/// The point where a line enters a circle, or the farther one where it leaves it.
std::optional<Vec2> onLine(const Vec2& point, const Vec2& heading, const PlanePath& arc, bool farther) {
    const double radius = arcRadius(arc);
    const double foot = glm::dot(arc.centre - point, heading);
    const double distance = cross(heading, arc.centre - point);
    if (std::abs(distance) > radius)
        return {};
    const double half = std::sqrt((radius - distance) * (radius + distance));
    return point + heading * (foot + (farther ? half : -half));
}

/// Where an arc ends and a line begins. LinuxCNC assumes that the distance of the centre from the programmed
/// corner is the radius of the programmed arc; for a motion into compensation with its centre beyond the end
/// this is not so, and the line begins at another place than beside its start.
std::optional<Vec2> arcMeetsLine(const PlanePath& before, const PlanePath& after, double offset) {
    const bool outside = roundOutside(before, offset);
    const double radius = arcRadius(before);
    const Vec2 heading = headingAtStart(after);
    const Vec2 left = leftOf(heading);
    const Vec2 spoke = before.centre - (after.start - left * offset);
    const double length = glm::length(spoke);
    const double assumed = radius + (outside ? -1 : 1) * std::abs(offset);
    const Vec2 direction = length > 0 ? spoke / length : Vec2(1, 0);
    const double distance = assumed * glm::dot(left, direction) - offset;
    if (std::abs(distance) > radius)
        return {};
    const double half = std::sqrt((radius - distance) * (radius + distance));
    return before.centre - left * distance + heading * (outside ? half : -half);
}

std::optional<Vec2> lineMeetsLine(const PlanePath& before, const PlanePath& after) {
    const Vec2 first = headingAtEnd(before);
    const Vec2 second = headingAtStart(after);
    const double sine = cross(first, second);
    if (sine == 0)
        return {};
    return before.end + first * (cross(after.start - before.end, second) / sine);
}

/// Of the two points where circles meet, the one that approaches the corner for a small tool.
std::optional<Vec2> arcMeetsArc(const PlanePath& before, const PlanePath& after, double offset) {
    const double firstRadius = arcRadius(before);
    const double secondRadius = arcRadius(after);
    const Vec2 between = after.centre - before.centre;
    const double distance = glm::length(between);
    if (distance == 0 || distance > firstRadius + secondRadius ||
        distance < std::abs(firstRadius - secondRadius))
        return {};
    const double along =
        (distance * distance + (firstRadius - secondRadius) * (firstRadius + secondRadius)) / (2 * distance);
    const double squared = (firstRadius - along) * (firstRadius + along);
    const double side = std::copysign(1.0, before.sweep * after.sweep) * std::copysign(1.0, offset);
    const Vec2 direction = between / distance;
    return before.centre + direction * along + leftOf(direction) * (side * std::sqrt(std::max(squared, 0.0)));
}

} // namespace

Vec2 headingAtStart(const PlanePath& path) {
    return path.arc() ? headingAt(path, path.start) : glm::normalize(path.end - path.start);
}

Vec2 headingAtEnd(const PlanePath& path) {
    return path.arc() ? headingAt(path, path.end) : glm::normalize(path.end - path.start);
}

Vec2 beside(const Vec2& point, const Vec2& heading, double offset) {
    return point + leftOf(heading) * offset;
}

bool roundOutside(const PlanePath& arc, double offset) {
    return (arc.sweep > 0) != (offset > 0);
}

std::optional<PlanePath> offsetPath(const PlanePath& path, double offset) {
    if (path.arc() && !roundOutside(path, offset) && arcRadius(path) - std::abs(offset) < kLeastRadius)
        return {};
    PlanePath result = path;
    result.start = beside(path.start, headingAtStart(path), offset);
    result.end = beside(path.end, headingAtEnd(path), offset);
    return result;
}

PlanePath entryPath(const PlanePath& path, double offset) {
    const Vec2 heading = headingAtEnd(path);
    PlanePath result = path;
    result.end = beside(path.end, heading, offset);
    if (!path.arc()) {
        result.start = beside(path.start, heading, offset);
        return result;
    }
    // The centre is as far from the start as from the end, on the spoke of the end.
    const Vec2 spoke = glm::normalize(path.centre - path.end);
    const Vec2 chord = path.start - result.end;
    result.centre = result.end + spoke * (glm::dot(chord, chord) / (2 * glm::dot(chord, spoke)));
    result.sweep = sweepBetween(result, result.start, result.end);
    return result;
}

Corner cornerBetween(const PlanePath& before, const Vec2& heading, const PlanePath& after, double offset) {
    const Vec2 next = headingAtStart(after);
    const double side = std::copysign(1.0, offset);
    double turn = -side * std::atan2(cross(heading, next), glm::dot(heading, next));
    if (turn <= kFlatCorner - kPi)
        turn += kTurn;
    // Straight back along or beside the previous path: an arc that curves away from the tool is in the tool's
    // way.
    const bool back = turn > kPi - kFlatCorner;
    const bool inTheWay =
        after.arc() ? roundOutside(after, offset) : before.arc() && roundOutside(before, offset);
    if (turn < -kFlatCorner || (back && inTheWay))
        return {CornerKind::inside, 0};
    return {turn > kFlatCorner ? CornerKind::outside : CornerKind::tangent, -side * turn};
}

std::optional<Vec2> meetingPoint(const PlanePath& before, const PlanePath& after, double offset) {
    if (before.arc() && after.arc())
        return arcMeetsArc(before, after, offset);
    if (after.arc())
        return onLine(before.end - slip(after), headingAtEnd(before), after, !roundOutside(after, offset));
    if (before.arc())
        return arcMeetsLine(before, after, offset);
    return lineMeetsLine(before, after);
}

double sweepBetween(const PlanePath& arc, const Vec2& start, const Vec2& end) {
    const Vec2 from = start - arc.centre;
    const Vec2 to = end - arc.centre;
    const double direction = std::copysign(1.0, arc.sweep);
    double sweep = direction * std::atan2(cross(from, to), glm::dot(from, to));
    if (sweep <= 0)
        sweep += kTurn;
    return direction * (sweep + kTurn * fullTurns(arc.sweep));
}

double sweepTolerance(bool inch) {
    return inch ? 0.001 : 0.0254;
}

bool goesForward(const PlanePath& path, const Vec2& start, const Vec2& end, double tolerance) {
    if (path.arc())
        return std::abs(sweepBetween(path, start, end)) <= std::abs(path.sweep) + tolerance;
    return glm::dot(end - start, path.end - path.start) > 0;
}

} // namespace proveout
