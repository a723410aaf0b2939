// SPDX-License-Identifier: GPL-3.0-or-later
// The vectors of Fanuc's cutter compensation: the positions of the tool centre between two blocks. In one
// plane, lengths in mm; pure functions. An `offset` is the tool's radius, positive if the tool is to the left
// of the path; `before` ends where `after` begins. Source: FANUC Series 0i and 30i, operator's manuals for
// machining centres, details of cutter compensation.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/base/geometry.h"
#include "core/nc/geometry/compensation.h"

namespace proveout {

/// The end of one block, the beginning of the next, and the points in between; the tool moves straight from
/// each to the next. At least one point.
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

/// In the offset mode. Nothing if the offset paths of an inside corner do not meet.
[[nodiscard]] std::optional<CornerPoints> cornerPoints(const PlanePath& before, const PlanePath& after,
                                                       double offset);

/// At the end of the straight start-up block; type A or B.
[[nodiscard]] CornerPoints startUpPoints(const PlanePath& before, const PlanePath& after, double offset,
                                         bool typeB);

/// At the beginning of the straight cancel block.
[[nodiscard]] CornerPoints cancelPoints(const PlanePath& before, const PlanePath& after, double offset,
                                        bool typeB);

/// Where the offset paths meet, at an inside or an outside corner; lengthened if necessary. The tool may
/// change its side there. Nothing if they do not meet.
[[nodiscard]] std::optional<Vec2> crossing(const PlanePath& before, double offset, const PlanePath& after,
                                           double offsetAfter);

/// Whether the blocks continue straight, so that there is no corner between them.
[[nodiscard]] bool goesStraightOn(const PlanePath& before, const PlanePath& after);

/// Removes the points that are within `limit` of the one before along both axes. All stay before an arc of
/// half a turn or more, which might otherwise vanish.
[[nodiscard]] CornerPoints withoutSmallMoves(const CornerPoints& points, double limit,
                                             const PlanePath& after);

/// The sweep of an arc with its ends moved; of the opposite sign if it then runs backward.
[[nodiscard]] double trimmedSweep(const PlanePath& arc, const Vec2& start, const Vec2& end);

/// The same as a control executes it: in the direction of the arc, at most one turn.
[[nodiscard]] double sweepWithin(const PlanePath& arc, const Vec2& start, const Vec2& end);

/// Whether an offset path from `start` to `end` runs against its programmed direction.
[[nodiscard]] bool goesBackward(const PlanePath& path, const Vec2& start, const Vec2& end);

} // namespace proveout
