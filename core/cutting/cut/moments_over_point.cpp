// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/moments_over_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cutting/cut/sweep.h"

namespace proveout {

namespace {

constexpr std::size_t kLegsOfRun = 16;

bool isCurved(const Motion& motion) {
    return motion.kind == MotionKind::arc && motion.sweep != 0;
}

/// The number of chords that are nowhere farther than kChordError from an arc.
std::size_t chordsOf(const Motion& motion) {
    if (!isCurved(motion))
        return 1;
    const PlaneAxes plane = axes(motion.plane);
    const Vec2 centre = inPlane(motion.centre, plane);
    const double radius = std::max({glm::distance(inPlane(motion.start, plane), centre),
                                    glm::distance(inPlane(motion.end, plane), centre), kChordError});
    const double angle = 2 * std::acos(1 - kChordError / radius);
    const double count = std::ceil(std::abs(motion.sweep) / angle);
    return static_cast<std::size_t>(std::clamp(count, 1.0, static_cast<double>(MomentsOverPoint::kMostLegs)));
}

double lowest(std::span<const ConvexProfile> profiles, const StraightPath& path, const Vec2& point) {
    double z = std::numeric_limits<double>::infinity();
    for (const ConvexProfile& profile : profiles)
        z = std::min(z, lowestContact(profile, path, point).z);
    return z;
}

StraightPath partOf(const StraightPath& path, double begin, double end) {
    StraightPath part = path;
    part.from += begin * path.along;
    part.z += begin * path.slope;
    part.length = end - begin;
    return part;
}

double squared(double value) {
    return value * value;
}

/// What is over one point, leg after leg.
class OverPoint {
public:
    OverPoint(std::span<const ConvexProfile> cutter, double cutterRim, std::span<const ConvexProfile> part,
              double reach, const Vec2& point, double height, double floorZ)
        : m_cutter(cutter), m_part(part), m_point(point), m_rim2(squared(cutterRim)),
          m_reach2(squared(reach)), m_floorZ(floorZ), m_material(height) {}

    void pass(const StraightPath& leg) {
        const Vec2 to = m_point - leg.from;
        const double along = to.x * leg.along.x + to.y * leg.along.y;
        const double across2 = squared(to.x * leg.along.y - to.y * leg.along.x);
        const double distance2 = squared(along - std::clamp(along, 0.0, leg.length)) + across2;
        if (distance2 > m_reach2)
            return;
        if (distance2 > m_rim2) {
            measure(leg);
            return;
        }
        m_passed = true;
        const double half = std::sqrt(m_rim2 - across2);
        if (along - half > 0)
            measure(partOf(leg, 0, along - half));
        m_material = std::min(m_material, lowest(m_cutter, leg, m_point));
        if (along + half < leg.length)
            measure(partOf(leg, along + half, leg.length));
    }

    [[nodiscard]] bool passed() const { return m_passed; }
    [[nodiscard]] double deepest() const { return m_deepest; }

private:
    void measure(const StraightPath& path) {
        m_deepest = std::max(m_deepest, m_material - std::max(m_floorZ, lowest(m_part, path, m_point)));
    }

    std::span<const ConvexProfile> m_cutter;
    std::span<const ConvexProfile> m_part;
    Vec2 m_point;
    double m_rim2;
    double m_reach2;
    double m_floorZ;
    double m_material;
    double m_deepest = 0;
    bool m_passed = false;
};

} // namespace

void MomentsOverPoint::prepare() {
    // A point on the rim is cut, and that of an arc is as far from the chords as these are from the arc.
    const double slack = isCurved(m_motion) ? kChordError : rimSlack(m_motion);
    m_cutter.assign(m_profiles.begin(), m_profiles.end());
    for (ConvexProfile& profile : m_cutter)
        profile.rim += slack;
    m_cutterRadius += slack;
    m_origin = Vec2(m_motion.start);
    addLegs(chordsOf(m_motion));
}

void MomentsOverPoint::addLegs(std::size_t count) {
    const Vec3 origin(m_origin, 0);
    Vec3 from = m_motion.start - origin;
    m_legs.reserve(count);
    for (std::size_t k = 1; k <= count; ++k) {
        const Vec3 to = pointAt(m_motion, static_cast<double>(k) / static_cast<double>(count)) - origin;
        if (k % kLegsOfRun == 1)
            m_runs.push_back({Vec2(from), Vec2(from), 0});
        m_legs.push_back(straightPath(from, to));
        Run& run = m_runs.back();
        run.lo = glm::min(run.lo, Vec2(to));
        run.hi = glm::max(run.hi, Vec2(to));
        run.end = k;
        from = to;
    }
}

std::optional<double> MomentsOverPoint::deepest(std::span<const ConvexProfile> part, double radius,
                                                const Vec2& point, double height) {
    if (m_cutter.empty())
        prepare();
    const Vec2 local = point - m_origin;
    const double reach = std::max(radius, m_cutterRadius);
    OverPoint over(m_cutter, m_cutterRadius, part, reach, local, height, m_floorZ);
    std::size_t leg = 0;
    for (const Run& run : m_runs) {
        const Vec2 beside = glm::max(glm::max(run.lo - local, local - run.hi), Vec2(0));
        for (leg = beside.x > reach || beside.y > reach ? run.end : leg; leg < run.end; ++leg)
            over.pass(m_legs[leg]);
    }
    if (!over.passed())
        return std::nullopt;
    return over.deepest();
}

} // namespace proveout
