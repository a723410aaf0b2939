// SPDX-License-Identifier: GPL-3.0-or-later
// The vectors of Fanuc's cutter compensation: where the centre of the tool stands between two blocks. In one
// plane, lengths in mm; pure functions. An `offset` is the tool's radius, positive where the tool goes on the
// left of the path; `before` ends where `after` begins.
// Source: FANUC Series 0i and 30i, operator's manuals for machining centres, details of cutter compensation.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/base/geometry.h"
#include "core/nc/geometry/compensation.h"

namespace proveout {

/// The end of one block, the beginning of the next, and what lies between; the tool goes straight from each
/// to the next. One point at least.
class CornerPoints {
public:
    void add(const Vec2& point) { m_points[m_count++] = point; }
    [[nodiscard]] const Vec2& first() const { return m_points.front(); }
    [[nodiscard]] const Vec2& last() const { return m_points[m_count - 1]; }
    [[nodiscard]] std::span<const Vec2> all() const { return {m_points.data(), m_count}; }

private:
    std::array<Vec2, 4> m_points{};
    std::size_t m_count = 0;
};

/// In the offset mode. Nothing where the offset paths of an inside corner do not meet.
[[nodiscard]] std::optional<CornerPoints> cornerPoints(const PlanePath& before, const PlanePath& after,
                                                       double offset);

/// At the end of the straight block into compensation; type A or B.
[[nodiscard]] CornerPoints startUpPoints(const PlanePath& before, const PlanePath& after, double offset,
                                         bool typeB);

/// At the beginning of the straight block out of it.
[[nodiscard]] CornerPoints cancelPoints(const PlanePath& before, const PlanePath& after, double offset,
                                        bool typeB);

/// Where the offset paths meet, whether the corner is an inside one or not; lengthened if need be. The tool
/// may change its side there. Nothing where they do not meet.
[[nodiscard]] std::optional<Vec2> crossing(const PlanePath& before, double offset, const PlanePath& after,
                                           double offsetAfter);

/// Whether the blocks go straight on, so that no corner lies between them.
[[nodiscard]] bool goesStraightOn(const PlanePath& before, const PlanePath& after);

/// Without the points that lie within `limit` of the one before along both axes. All stay before an arc of
/// half a turn or more, which might become none.
[[nodiscard]] CornerPoints withoutSmallMoves(const CornerPoints& points, double limit,
                                             const PlanePath& after);

/// The sweep of an arc that begins and ends at other points than it did; of the other sign where it then goes
/// backward.
[[nodiscard]] double trimmedSweep(const PlanePath& arc, const Vec2& start, const Vec2& end);

/// The same as a control runs it: in the direction of the arc, once round at most.
[[nodiscard]] double sweepWithin(const PlanePath& arc, const Vec2& start, const Vec2& end);

/// Whether an offset path that is to lead from `start` to `end` goes against its programmed direction.
[[nodiscard]] bool goesBackward(const PlanePath& path, const Vec2& start, const Vec2& end);

} // namespace proveout
