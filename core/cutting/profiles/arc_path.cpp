// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/profiles/arc_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace proveout {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Radii that differ by less count as those of a circle: a hundred-thousandth of the promised accuracy.
constexpr double kSameRadius = 1e-8;

/// Keeps only the turn that determines the result if a circle is traversed more than once.
void keepLowestTurn(ArcPath& path) {
    const double turn = kTurn / std::abs(path.sweep);
    if (turn >= 1 || path.widening != 0)
        return;
    const bool flat = path.normal == 2;
    if (!flat && path.climb != 0)
        return;
    if (flat && path.climb < 0)
        path.begin = 1 - turn;
    else
        path.end = turn;
}

} // namespace

Vec3 ArcPath::at(double t) const {
    const double r = radius + widening * t;
    const double phi = angle + sweep * t;
    Vec3 place = centre;
    place[first] += r * std::cos(phi);
    place[second] += r * std::sin(phi);
    place[normal] += climb * t;
    return place;
}

ArcPath::Tangent ArcPath::tangentAt(double t) const {
    const double r = radius + widening * t;
    const double phi = angle + sweep * t;
    const double cosine = std::cos(phi);
    const double sine = std::sin(phi);
    Tangent tangent{centre, Vec3(0)};
    tangent.place[first] += r * cosine;
    tangent.place[second] += r * sine;
    tangent.place[normal] += climb * t;
    tangent.rate[first] = widening * cosine - r * sweep * sine;
    tangent.rate[second] = widening * sine + r * sweep * cosine;
    tangent.rate[normal] = climb;
    return tangent;
}

double ArcPath::bend() const {
    const double largest = std::max(std::abs(radius), std::abs(radius + widening));
    return sweep * sweep * largest + 2 * std::abs(widening * sweep);
}

bool ArcPath::levelCircle() const {
    return normal == 2 && climb == 0 && widening == 0;
}

double ArcPath::distanceToCircle(const Vec2& point) const {
    const Vec2 to = point - Vec2(centre);
    const double turned = std::remainder(std::atan2(to.y, to.x) - angle - sweep * begin, kTurn) / sweep;
    const double onwards = turned < 0 ? turned + kTurn / std::abs(sweep) : turned;
    if (begin + onwards <= end)
        return std::abs(std::hypot(to.x, to.y) - radius);
    return std::min(glm::distance(point, Vec2(at(begin))), glm::distance(point, Vec2(at(end))));
}

double ArcPath::beside(const Vec2& point) const {
    if (normal != 2) {
        const Vec2 from(at(begin));
        const Vec2 along = Vec2(at(end)) - from;
        const double length = std::hypot(along.x, along.y);
        const Vec2 off = point - from;
        return length > 0 ? (off.y * along.x - off.x * along.y) / length : off.y;
    }
    const Vec2 to = point - Vec2(centre);
    const double distance = std::hypot(to.x, to.y);
    const double turned = std::remainder(std::atan2(to.y, to.x) - angle - sweep * begin, kTurn) / sweep;
    const double turn = kTurn / std::abs(sweep);
    double nearest = std::numeric_limits<double>::infinity();
    const double before = begin + turned - turn * std::ceil(turned / turn);
    for (double t = before; t < end + turn; t += turn) {
        const double off = distance - radius - widening * std::clamp(t, begin, end);
        nearest = std::abs(off) < std::abs(nearest) ? off : nearest;
    }
    return sweep > 0 ? -nearest : nearest;
}

ArcPath arcPath(const Motion& motion, const Vec3& origin) {
    const auto [first, second, normal] = axes(motion.plane);
    ArcPath path;
    path.first = first;
    path.second = second;
    path.normal = normal;
    path.centre = motion.centre - origin;
    path.centre[normal] = motion.start[normal] - origin[normal];
    const auto radiusTo = [&](const Vec3& place) {
        const Vec3 off = place - motion.centre;
        return std::hypot(off[path.first], off[path.second]);
    };
    path.radius = radiusTo(motion.start);
    path.widening = radiusTo(motion.end) - path.radius;
    if (std::abs(path.widening) <= kSameRadius)
        path.widening = 0;
    path.angle =
        std::atan2(motion.start[second] - motion.centre[second], motion.start[first] - motion.centre[first]);
    path.sweep = motion.sweep;
    path.climb = motion.end[normal] - motion.start[normal];
    keepLowestTurn(path);
    return path;
}

} // namespace proveout
