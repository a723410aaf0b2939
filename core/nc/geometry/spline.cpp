// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/geometry/spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace proveout {

namespace {

/// A point of a rational curve: x and y multiplied by the weight, and the weight.
using Weighted = Vec3;

Weighted weighted(const ControlPoint& point) {
    return {point.at * point.weight, point.weight};
}

Vec2 place(const Weighted& point) {
    return {point.x / point.z, point.y / point.z};
}

Weighted between(const Weighted& a, const Weighted& b, double t) {
    return a * (1 - t) + b * t;
}

/// The control points of one Bézier curve.
struct Bezier {
    std::array<Weighted, kMostSplineOrder> points;
    std::size_t count;

    [[nodiscard]] std::span<const Weighted> all() const { return {points.data(), count}; }
};

/// The knots of a spline with `points` control points, by index.
class Knots {
public:
    Knots(std::size_t points, std::size_t order) : m_points(points), m_order(order) {}

    [[nodiscard]] std::size_t spans() const { return m_points - m_order + 1; }
    [[nodiscard]] double operator[](std::size_t index) const {
        const std::size_t last = m_order - 1;
        return index <= last ? 0.0 : static_cast<double>(std::min(index - last, spans()));
    }

private:
    std::size_t m_points;
    std::size_t m_order;
};

/// The polar form of the piece between the knots `span` and `span` + 1: its first `upper` arguments are the
/// upper knot, all others the lower one.
Weighted polarForm(const Spline& spline, const Knots& knots, std::size_t span, std::size_t upper) {
    const auto degree = static_cast<std::size_t>(spline.order) - 1;
    const std::size_t first = span; // the piece depends on the points span … span + degree
    std::array<Weighted, kMostSplineOrder> points;
    for (std::size_t i = 0; i <= degree; ++i)
        points[i] = weighted(spline.points[first + i]);
    for (std::size_t round = 1; round <= degree; ++round) {
        const double argument = static_cast<double>(round <= upper ? span + 1 : span);
        for (std::size_t i = degree; i >= round; --i) {
            const double low = knots[first + i];
            const double high = knots[first + i + degree + 1 - round];
            points[i] = between(points[i - 1], points[i], (argument - low) / (high - low));
        }
    }
    return points[degree];
}

Bezier pieceOf(const Spline& spline, const Knots& knots, std::size_t span) {
    Bezier piece{{}, static_cast<std::size_t>(spline.order)};
    for (std::size_t i = 0; i < piece.count; ++i)
        piece.points[i] = polarForm(spline, knots, span, i);
    return piece;
}

double distanceFromSegment(const Vec2& point, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::length(point - a - along * t);
}

bool closeToChord(const Bezier& curve, double chordError) {
    const Vec2 begin = place(curve.points.front());
    const Vec2 end = place(curve.points[curve.count - 1]);
    return std::ranges::all_of(curve.all(), [&](const Weighted& point) {
        return distanceFromSegment(place(point), begin, end) <= chordError;
    });
}

/// The two halves of a curve, by de Casteljau.
struct Halves {
    Bezier first;
    Bezier second;
};
Halves halved(const Bezier& curve) {
    Halves halves{curve, curve};
    std::array<Weighted, kMostSplineOrder> points = curve.points;
    for (std::size_t round = 0; round < curve.count; ++round) {
        halves.first.points[round] = points.front();
        halves.second.points[curve.count - 1 - round] = points[curve.count - 1 - round];
        for (std::size_t i = 0; i + 1 < curve.count - round; ++i)
            points[i] = between(points[i], points[i + 1], 0.5);
    }
    return halves;
}

/// False if there are too many points.
bool appendFlattened(const Bezier& curve, double chordError, std::vector<Vec2>& points) {
    // At this depth, halving no longer changes a number of this precision.
    constexpr std::size_t kDeepest = 50;
    std::vector<Bezier> rest{curve};
    while (!rest.empty()) {
        if (points.size() == kMostSplinePoints)
            return false;
        const Bezier next = rest.back();
        rest.pop_back();
        if (rest.size() >= kDeepest || closeToChord(next, chordError)) {
            points.push_back(place(next.points[next.count - 1]));
            continue;
        }
        const Halves halves = halved(next);
        rest.push_back(halves.second);
        rest.push_back(halves.first);
    }
    return true;
}

} // namespace

std::optional<std::vector<Vec2>> flattened(const Spline& spline, double chordError) {
    const Knots knots(spline.points.size(), static_cast<std::size_t>(spline.order));
    std::vector<Vec2> points;
    for (std::size_t span = 0; span < knots.spans(); ++span) {
        if (!appendFlattened(pieceOf(spline, knots, span), chordError, points))
            return {};
    }
    points.back() = spline.points.back().at;
    return points;
}

} // namespace proveout
