// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/flat_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/cutting/cut/sweep.h"
#include "core/cutting/profiles/convex_profile.h"

namespace proveout {

namespace {

/// The largest radius at which a profile is not above a height.
double radiusOf(const ConvexProfile& profile, double height) {
    if (height < profile.z0)
        return 0;
    if (profile.side == ConvexProfile::Side::line)
        return std::min(profile.flatTo + (height - profile.z0) / profile.slope, profile.rim);
    if (profile.side == ConvexProfile::Side::arc && height < profile.centreZ) {
        const double down = profile.centreZ - height;
        const double out = std::sqrt(std::max(0.0, profile.radius * profile.radius - down * down));
        return std::min(std::max(profile.flatTo, profile.centreR + out), profile.rim);
    }
    return profile.rim;
}

/// The same line with X and Y exchanged.
StraightPath exchanged(StraightPath path) {
    std::swap(path.from.x, path.from.y);
    std::swap(path.along.x, path.along.y);
    return path;
}

void addColumns(const Columns& columns, FlatPass::Row& row) {
    if (columns.empty())
        return;
    const auto count = static_cast<std::size_t>(columns.end - columns.begin);
    row |= ~FlatPass::Row{} >> (row.size() - count) << static_cast<std::size_t>(columns.begin);
}

} // namespace

CutterEnd::CutterEnd(const Cutter& cutter)
    : m_profiles(convexProfiles(cutter, 0)), m_lowest(std::numeric_limits<double>::infinity()) {
    for (const ConvexProfile& profile : m_profiles)
        m_lowest = std::min(m_lowest, profile.z0);
}

double CutterEnd::radiusUpTo(double height) const {
    double radius = 0;
    for (const ConvexProfile& profile : m_profiles)
        radius = std::max(radius, radiusOf(profile, height));
    return radius;
}

std::optional<FlatPass> FlatPass::of(const CutterEnd& end, const Motion& motion, double topZ,
                                     double stockFloor) {
    if (!motion.known() || !withinLimits(motion))
        return std::nullopt;
    const double tip = std::min(motion.start.z, motion.end.z) - topZ;
    const double radius = end.radiusUpTo(std::max(end.lowest(), stockFloor - tip));
    if (!(radius > 0))
        return std::nullopt;
    FlatPass pass;
    const Vec3 origin(motion.start.x, motion.start.y, topZ);
    pass.m_origin = Vec2(origin);
    pass.m_radius = radius + rimSlack(motion);
    pass.m_height = std::max(tip + end.lowest(), stockFloor);
    if (motion.kind == MotionKind::arc && motion.sweep != 0) {
        pass.m_circle = arcPath(motion, origin);
        if (!pass.m_circle->levelCircle())
            return std::nullopt;
        pass.m_circleParts = splitArc(*pass.m_circle);
        std::ranges::sort(pass.m_circleParts, {}, &ArcPart::middle);
    } else {
        pass.m_straight = straightPath(motion.start - origin, motion.end - origin);
        if (pass.m_straight.slope != 0 && pass.m_straight.length > 0)
            return std::nullopt;
    }
    return pass;
}

PlanArea FlatPass::areaOf(std::size_t part) const {
    const Vec2 end = m_straight.from + m_straight.length * m_straight.along;
    const Vec2 lo = m_circle ? m_circleParts[part].lo : glm::min(m_straight.from, end);
    const Vec2 hi = m_circle ? m_circleParts[part].hi : glm::max(m_straight.from, end);
    return {m_origin + lo - m_radius, m_origin + hi + m_radius};
}

bool FlatPass::covers(std::size_t part, const Vec2& place) const {
    const Vec2 point = place - m_origin;
    if (m_circle) {
        ArcPath path = *m_circle;
        path.begin = m_circleParts[part].middle - m_circleParts[part].half;
        path.end = m_circleParts[part].middle + m_circleParts[part].half;
        return path.distanceToCircle(point) <= m_radius;
    }
    const Vec2 to = point - m_straight.from;
    const double along = std::clamp(glm::dot(to, m_straight.along), 0.0, m_straight.length);
    return glm::length(to - along * m_straight.along) <= m_radius;
}

bool FlatPass::mayLeavePillar(double edge) const {
    return m_circle && m_circle->radius > m_radius && m_circle->radius - m_radius < 2 * edge;
}

Span FlatPass::spanOn(std::size_t part, const Vec2& from, bool alongY) const {
    Vec2 start = from - m_origin;
    StraightPath line = m_circle ? m_circleParts[part].chord : m_straight;
    if (alongY) {
        std::swap(start.x, start.y);
        line = exchanged(line);
    }
    const auto within = [&](double radius) {
        const Span span = rowSpan(line, radius, start.y);
        return Span{span.lo - start.x, span.hi - start.x};
    };
    if (!m_circle)
        return within(m_radius);
    const auto isUnder = [&](double way) {
        return covers(part, from + (alongY ? Vec2(0, way) : Vec2(way, 0)));
    };
    const double bulge = m_circleParts[part].bulge;
    const Span most = within(m_radius + bulge);
    Span span = within(m_radius - bulge);
    if (span.lo > span.hi)
        span = {(most.lo + most.hi) / 2, (most.lo + most.hi) / 2};
    if (most.lo > most.hi || !isUnder(span.lo))
        return {1, 0};
    const auto endBetween = [&](double inside, double outside) {
        constexpr int kHalvingsOfEnd = 30;
        for (int k = 0; k < kHalvingsOfEnd; ++k) {
            const double middle = (inside + outside) / 2;
            (isUnder(middle) ? inside : outside) = middle;
        }
        return inside;
    };
    return {endBetween(span.lo, most.lo), endBetween(span.hi, most.hi)};
}

FlatPass::Row FlatPass::pointsUnder(std::size_t part, const RowPoints& row) const {
    Row points;
    const RowPoints local{row.x - m_origin.x, row.step, row.y - m_origin.y, row.count};
    if (!m_circle) {
        addColumns(columnsUnder(rowSpan(m_straight, m_radius, local.y), local), points);
        return points;
    }
    const ArcPart& arc = m_circleParts[part];
    const Columns surely = columnsUnder(rowSpan(arc.chord, m_radius - arc.bulge, local.y), local);
    const Columns perhaps = columnsUnder(rowSpan(arc.chord, m_radius + arc.bulge, local.y), local);
    addColumns(surely, points);
    for (int i = perhaps.begin; i < perhaps.end; ++i)
        if (!points.test(static_cast<std::size_t>(i)) &&
            m_circle->distanceToCircle({local.x + local.step * i, local.y}) <= m_radius)
            points.set(static_cast<std::size_t>(i));
    return points;
}

} // namespace proveout
