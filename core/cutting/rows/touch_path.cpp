// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/rows/touch_path.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// Moving along a wall that the cutter itself has left does not count as touching it.
constexpr double kWithinRim = 1e-6;
constexpr double kFine = 1e-9; ///< mm of the path

} // namespace

TouchPath::TouchPath(const Cutter& cutter, const Vec3& start, const Vec3& end, double grown)
    : m_profiles(convexProfiles(cutter, -kWithinRim)), m_start(start), m_end(end),
      m_length(glm::distance(start, end)),
      m_path(straightPath({0, 0, start.z}, {end.x - start.x, end.y - start.y, end.z})) {
    for (ConvexProfile& profile : m_profiles) {
        if (grown > 0)
            profile = profile.dilated(grown);
        m_rim = std::max(m_rim, profile.rim);
    }
}

double TouchPath::firstTouch(const Vec2& place, double height) const {
    double first = kNever;
    for (const ConvexProfile& profile : m_profiles)
        first = std::min(first, firstTouch(profile, place - Vec2(m_start), height));
    return first;
}

double TouchPath::firstTouchPlunging(const ConvexProfile& profile, double distance, double height) const {
    if (distance > profile.rim)
        return kNever;
    const double down = m_start.z + profile.height(distance) - height; // distance to go until it touches
    if (down <= 0)
        return 0;
    const double fall = m_start.z - m_end.z;
    return down <= fall ? down / fall : kNever;
}

/// The height of the cutter over the place is convex in time while the place is under it, so that it only
/// falls before it is lowest.
double TouchPath::firstTouch(const ConvexProfile& profile, const Vec2& place, double height) const {
    if (m_path.length == 0)
        return firstTouchPlunging(profile, glm::length(place), height);
    const Contact lowest = lowestContact(profile, m_path, place);
    if (!(lowest.z <= height))
        return kNever;
    const double ahead = glm::dot(place, m_path.along);
    const double across2 = std::max(0.0, glm::dot(place, place) - ahead * ahead);
    const auto heightAt = [&](double along) {
        const double distance = std::sqrt(across2 + (ahead - along) * (ahead - along));
        return m_path.z + m_path.slope * along + profile.height(std::min(distance, profile.rim));
    };
    double before = std::max(0.0, ahead - std::sqrt(std::max(0.0, profile.rim * profile.rim - across2)));
    double behind = std::max(before, lowest.along);
    if (heightAt(before) <= height)
        return before / m_path.length;
    while (behind - before > kFine) {
        const double middle = (before + behind) / 2;
        if (middle == before || middle == behind)
            break;
        (heightAt(middle) <= height ? behind : before) = middle;
    }
    return behind / m_path.length;
}

Span TouchPath::rowSpan(double y) const {
    const Span span = proveout::rowSpan(m_path, m_rim, y - m_start.y);
    return {span.lo + m_start.x, span.hi + m_start.x};
}

Span TouchPath::rows() const {
    return {std::min(m_start.y, m_end.y) - m_rim, std::max(m_start.y, m_end.y) + m_rim};
}

double TouchPath::lowest() const {
    double tip = TouchPath::kNever;
    for (const ConvexProfile& profile : m_profiles)
        tip = std::min(tip, profile.z0);
    return std::min(m_start.z, m_end.z) + tip;
}

} // namespace proveout
