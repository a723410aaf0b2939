// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/rim_crossings.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// Where walls turn by more, two rims are those of two walls that meet in a corner; by less, of one that is
/// round.
constexpr double kCorner = 0.64; // the sine of 40°

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

} // namespace

OnWall onWall(const RimCrossing& a, const RimCrossing& b) {
    const Vec2 chord = b.at - a.at;
    const double length2 = glm::dot(chord, chord);
    if (!(length2 > 0))
        return {a.at, a.normal};
    const Vec2 left(-chord.y, chord.x);
    // The slopes of the curve against its chord.
    const auto slope = [&](const Vec2& normal) {
        const double up = glm::dot(normal, left);
        return std::abs(up) > 0 ? -glm::dot(normal, chord) / up : 0.0;
    };
    const double t = std::clamp(-glm::dot(a.at, chord) / length2, 0.0, 1.0);
    const double beside = t * (1 - t) * ((1 - t) * slope(a.normal) - t * slope(b.normal));
    const bool isCorner = std::abs(cross(a.normal, b.normal)) > kCorner || glm::dot(a.normal, b.normal) < 0;
    return {a.at + t * chord + beside * left,
            isCorner ? Vec2(0) : glm::normalize(glm::mix(a.normal, b.normal, t))};
}

std::optional<Vec2> cornerOf(const RimCrossing& a, const RimCrossing& b) {
    const double turn = cross(a.normal, b.normal);
    if (std::abs(turn) < kCorner)
        return std::nullopt;
    const double alongA = glm::dot(a.normal, a.at);
    const double alongB = glm::dot(b.normal, b.at);
    return Vec2(alongA * b.normal.y - alongB * a.normal.y, a.normal.x * alongB - b.normal.x * alongA) / turn;
}

} // namespace proveout
