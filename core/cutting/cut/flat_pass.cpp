// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/flat_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cutting/cut/sweep.h"
#include "core/cutting/profiles/convex_profile.h"

namespace proveout {

namespace {

void addColumns(const Columns& columns, FlatPass::Row& row) {
    if (columns.empty())
        return;
    const auto count = static_cast<std::size_t>(columns.end - columns.begin);
    row |= ~FlatPass::Row{} >> (row.size() - count) << static_cast<std::size_t>(columns.begin);
}

} // namespace

FlatEnd::FlatEnd(const Cutter& cutter) : height(std::numeric_limits<double>::infinity()), radius(0) {
    for (const ConvexProfile& profile : convexProfiles(cutter, 0)) {
        if (profile.z0 > height)
            continue;
        radius = profile.z0 < height ? profile.flatTo : std::max(radius, profile.flatTo);
        height = profile.z0;
    }
}

std::optional<FlatPass> FlatPass::of(const FlatEnd& end, const Motion& motion, double topZ) {
    if (!(end.radius > 0) || !motion.known() || !withinLimits(motion))
        return std::nullopt;
    FlatPass pass;
    const Vec3 origin(motion.start.x, motion.start.y, topZ);
    pass.m_origin = Vec2(origin);
    pass.m_radius = end.radius + rimSlack(motion);
    if (motion.kind == MotionKind::arc && motion.sweep != 0) {
        pass.m_circle = arcPath(motion, origin);
        if (!pass.m_circle->levelCircle())
            return std::nullopt;
        pass.m_height = pass.m_circle->centre.z + end.height;
        pass.m_circleParts = splitArc(*pass.m_circle);
        std::ranges::sort(pass.m_circleParts, {}, &ArcPart::middle);
    } else {
        pass.m_straight = straightPath(motion.start - origin, motion.end - origin);
        if (pass.m_straight.slope != 0 && pass.m_straight.length > 0)
            return std::nullopt;
        pass.m_height = pass.m_straight.z + end.height;
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
