// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/geometry/corner_vectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace proveout {

namespace {

constexpr double kPi = std::numbers::pi;
/// In radians: blocks that turn by less count as straight, because their meeting points would be arbitrary.
constexpr double kStraight = 1e-6;
/// A right angle, with a tolerance for rounding.
constexpr double kObtuse = kPi / 2 + 1e-9;
/// Type B does not round sharper start-up corners of lines.
constexpr double kSharpest = kPi - kPi / 180;
/// The distance by which circles may miss each other and still touch, relative to their radius.
constexpr double kTouching = 1e-9;
/// Points closer than this, in mm, count as one.
constexpr double kSamePoint = 1e-9;

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

Vec2 leftOf(const Vec2& v) {
    return {-v.y, v.x};
}

/// Signed angle from `a` to `b`, in (-pi, pi].
double angleFrom(const Vec2& a, const Vec2& b) {
    return std::atan2(cross(a, b), glm::dot(a, b));
}

/// A corner as seen from the tool.
struct Joint {
    Vec2 point; ///< programmed
    Vec2 heading;
    Vec2 next;
    Vec2 ended;  ///< at a right angle beside the end of the first block
    Vec2 begun;  ///< at a right angle beside the beginning of the second
    double turn; ///< towards the tool
    bool inside;
};

/// Positive to the left.
double curvature(const PlanePath& path, const Vec2& point) {
    return path.arc() ? std::copysign(1.0, path.sweep) / glm::distance(point, path.centre) : 0.0;
}

/// Whether the corner is an inside one; if the path turns straight back, it is one if the paths curve so that
/// the tool is between them.
bool isInside(const PlanePath& before, const PlanePath& after, double side, double turn) {
    if (std::abs(turn) < kPi - kStraight)
        return turn > 0;
    return side * (curvature(before, before.end) + curvature(after, after.start)) < 0;
}

Joint jointOf(const PlanePath& before, const PlanePath& after, double offset) {
    const Vec2 heading = headingAtEnd(before);
    const Vec2 next = headingAtStart(after);
    const double side = std::copysign(1.0, offset);
    const double turn = side * angleFrom(heading, next);
    return {before.end,
            heading,
            next,
            beside(before.end, heading, offset),
            beside(after.start, next, offset),
            turn,
            isInside(before, after, side, turn)};
}

/// An offset path near a corner: a line, or the circle through the point beside the corner.
struct Curve {
    Vec2 point;
    Vec2 heading;
    double sense; ///< of an arc: 1 counter-clockwise, -1 clockwise; 0: straight
    Vec2 centre;

    [[nodiscard]] bool arc() const { return sense != 0; }
    [[nodiscard]] double radius() const { return glm::distance(point, centre); }
    /// How far before `point` the path passes `place`; places that rounding moves beyond the point are at it.
    [[nodiscard]] double wayFrom(const Vec2& place) const {
        if (!arc())
            return glm::dot(point - place, heading);
        const double angle = sense * angleFrom(place - centre, point - centre);
        return radius() * (angle < -kStraight ? angle + 2 * kPi : angle);
    }
};

/// The points where two curves meet.
class Meetings {
public:
    Meetings(const Curve& a, const Curve& b) {
        if (a.arc() && b.arc())
            circles(a, b);
        else if (a.arc() || b.arc())
            lineAndCircle(a.arc() ? b : a, a.arc() ? a : b);
        else
            lines(a, b);
    }

    [[nodiscard]] std::optional<Vec2> nearest(const Vec2& place) const {
        if (m_count == 0)
            return {};
        return glm::distance(m_points[0], place) <= glm::distance(m_points[1], place) ? m_points[0]
                                                                                      : m_points[1];
    }

    /// The last one before the corner.
    [[nodiscard]] std::optional<Vec2> lastOn(const Curve& before) const {
        if (m_count == 0)
            return {};
        const double first = before.wayFrom(m_points[0]);
        const double second = before.wayFrom(m_points[1]);
        const bool prefersFirst =
            (first >= -kSamePoint) == (second >= -kSamePoint) ? first <= second : first > second;
        return m_points[prefersFirst ? 0 : 1];
    }

private:
    void lines(const Curve& a, const Curve& b) {
        const double sine = cross(a.heading, b.heading);
        if (std::abs(sine) > kStraight)
            add(a.point + a.heading * (cross(b.point - a.point, b.heading) / sine), Vec2(0));
    }

    void lineAndCircle(const Curve& line, const Curve& circle) {
        const double along = glm::dot(circle.centre - line.point, line.heading);
        const double distance = cross(line.heading, circle.centre - line.point);
        const double radius = circle.radius();
        if (std::abs(distance) > radius * (1 + kTouching))
            return;
        const double half = std::sqrt(std::max(0.0, (radius - distance) * (radius + distance)));
        add(line.point + line.heading * along, line.heading * half);
    }

    void circles(const Curve& a, const Curve& b) {
        const double radius = a.radius();
        const double other = b.radius();
        const Vec2 between = b.centre - a.centre;
        const double distance = glm::length(between);
        const double touching = (radius + other) * kTouching;
        if (distance < kSamePoint || distance > radius + other + touching ||
            distance < std::abs(radius - other) - touching)
            return;
        const double along = (distance * distance + (radius - other) * (radius + other)) / (2 * distance);
        const double half = std::sqrt(std::max(0.0, (radius - along) * (radius + along)));
        add(a.centre + between * (along / distance), leftOf(between) * (half / distance));
    }

    void add(const Vec2& middle, const Vec2& half) {
        m_points = {middle - half, middle + half};
        m_count = 2;
    }

    std::array<Vec2, 2> m_points{};
    std::size_t m_count = 0;
};

Curve curveOf(const PlanePath& path, const Vec2& point, const Vec2& heading) {
    return {point, heading, path.arc() ? std::copysign(1.0, path.sweep) : 0.0, path.centre};
}

/// Arcs are replaced by their tangents at the corner. The tangents are extended until they meet, or each by
/// the radius if that is too far away.
CornerPoints outsidePoints(const PlanePath& before, const PlanePath& after, const Joint& joint,
                           double offset) {
    CornerPoints points;
    if (before.arc())
        points.add(joint.ended);
    if (std::abs(joint.turn) <= kObtuse) {
        const Vec2 normals = leftOf(joint.heading + joint.next);
        points.add(joint.point + normals * (offset / (1 + glm::dot(joint.heading, joint.next))));
    } else {
        points.add(joint.ended + joint.heading * std::abs(offset));
        points.add(joint.begun - joint.next * std::abs(offset));
    }
    if (after.arc())
        points.add(joint.begun);
    return points;
}

CornerPoints onePoint(const Vec2& point) {
    CornerPoints points;
    points.add(point);
    return points;
}

/// Whether type B rounds the corner between a compensated and an uncompensated block.
bool isRounded(const PlanePath& before, const PlanePath& after, const Joint& joint) {
    const bool lines = !before.arc() && !after.arc();
    return !joint.inside && std::abs(joint.turn) >= kStraight && !(lines && std::abs(joint.turn) > kSharpest);
}

} // namespace

std::optional<CornerPoints> cornerPoints(const PlanePath& before, const PlanePath& after, double offset) {
    const Joint joint = jointOf(before, after, offset);
    if (std::abs(joint.turn) < kStraight)
        return onePoint(joint.begun);
    if (!joint.inside)
        return outsidePoints(before, after, joint, offset);
    const Curve first = curveOf(before, joint.ended, joint.heading);
    const auto meeting = Meetings(first, curveOf(after, joint.begun, joint.next)).lastOn(first);
    return meeting ? std::optional(onePoint(*meeting)) : std::nullopt;
}

CornerPoints startUpPoints(const PlanePath& before, const PlanePath& after, double offset, bool typeB) {
    const Joint joint = jointOf(before, after, offset);
    return typeB && isRounded(before, after, joint) ? outsidePoints(before, after, joint, offset)
                                                    : onePoint(joint.begun);
}

CornerPoints cancelPoints(const PlanePath& before, const PlanePath& after, double offset, bool typeB) {
    const Joint joint = jointOf(before, after, offset);
    return typeB && isRounded(before, after, joint) ? outsidePoints(before, after, joint, offset)
                                                    : onePoint(joint.ended);
}

std::optional<Vec2> crossing(const PlanePath& before, double offset, const PlanePath& after,
                             double offsetAfter) {
    const Joint joint = jointOf(before, after, offset);
    const Vec2 begun = beside(after.start, joint.next, offsetAfter);
    return Meetings(curveOf(before, joint.ended, joint.heading), curveOf(after, begun, joint.next))
        .nearest(joint.point);
}

bool goesStraightOn(const PlanePath& before, const PlanePath& after) {
    return std::abs(jointOf(before, after, 1).turn) < kStraight;
}

CornerPoints withoutSmallMoves(const CornerPoints& points, double limit, const PlanePath& after) {
    const double close = std::abs(after.sweep) >= kPi ? kSamePoint : std::max(limit, kSamePoint);
    CornerPoints result = onePoint(points.first());
    for (const Vec2& point : points.all().subspan(1)) {
        const Vec2 way = glm::abs(point - result.last());
        if (std::max(way.x, way.y) > close)
            result.add(point);
    }
    return result;
}

double trimmedSweep(const PlanePath& arc, const Vec2& start, const Vec2& end) {
    return arc.sweep - angleFrom(arc.start - arc.centre, start - arc.centre) -
           angleFrom(end - arc.centre, arc.end - arc.centre);
}

double sweepWithin(const PlanePath& arc, const Vec2& start, const Vec2& end) {
    const double direction = std::copysign(1.0, arc.sweep);
    const double along = std::fmod(direction * trimmedSweep(arc, start, end), 2 * kPi);
    return direction * (along <= 0 ? along + 2 * kPi : along);
}

bool goesBackward(const PlanePath& path, const Vec2& start, const Vec2& end) {
    if (path.arc())
        return trimmedSweep(path, start, end) * std::copysign(1.0, path.sweep) <= 0;
    const Vec2 way = end - start;
    return glm::dot(way, path.end - path.start) < -kSamePoint * glm::distance(path.end, path.start);
}

} // namespace proveout
