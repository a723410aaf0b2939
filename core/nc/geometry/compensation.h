// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry of cutter compensation: paths beside a path, and how they join. In one plane, lengths in mm;
// pure functions. An `offset` is the tool's radius, positive where the tool goes on the left of the path.
// Source: what LinuxCNC's interpreter does, found out by running it.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/geometry.h"

namespace proveout {

/// A motion shorter than this in the plane, in mm, leads nowhere there.
inline constexpr double kNoLength = 1e-9;

/// A straight or circular path. The radius at both ends of an arc may differ a little.
struct PlanePath {
    Vec2 start{0};
    Vec2 end{0};
    Vec2 centre{0};
    double sweep = 0; ///< of an arc, counter-clockwise positive, may exceed a turn; 0: straight

    [[nodiscard]] bool arc() const { return sweep != 0; }
};

/// Unit vectors along the path at its ends. The path must have a length.
[[nodiscard]] Vec2 headingAtStart(const PlanePath& path);
[[nodiscard]] Vec2 headingAtEnd(const PlanePath& path);

/// The point beside `point` for a path that comes by with `heading`.
[[nodiscard]] Vec2 beside(const Vec2& point, const Vec2& heading, double offset);

/// Whether the tool goes round an arc on the side away from its centre.
[[nodiscard]] bool roundOutside(const PlanePath& arc, double offset);

/// The path at the distance of the tool's radius. Nothing where the tool does not fit into the arc.
[[nodiscard]] std::optional<PlanePath> offsetPath(const PlanePath& path, double offset);

/// The motion into compensation: from its start, where the tool is on the path, to the point square beside
/// its end. An arc gets another radius about a centre on the spoke of its end, or beyond that end.
[[nodiscard]] PlanePath entryPath(const PlanePath& path, double offset);

enum class CornerKind : std::uint8_t {
    tangent, ///< nearly straight on: the tool goes on from where it is
    outside, ///< the tool rolls about the corner
    inside,  ///< both paths end where they meet
};
struct Corner {
    CornerKind kind;
    double sweep; ///< outside: of the arc about the corner
};
/// What lies between two offset paths; `heading` is the programmed one at the end of the first, from which
/// the motion into compensation may differ.
[[nodiscard]] Corner cornerBetween(const PlanePath& before, const Vec2& heading, const PlanePath& after,
                                   double offset);

/// Where two offset paths of an inside corner meet; they may have to be lengthened for it. Nothing where
/// they do not.
[[nodiscard]] std::optional<Vec2> meetingPoint(const PlanePath& before, const PlanePath& after,
                                               double offset);

/// The sweep of an arc that begins and ends at other points than it did: in its direction, with its full
/// turns.
[[nodiscard]] double sweepBetween(const PlanePath& arc, const Vec2& start, const Vec2& end);

/// How much longer an arc may become at its ends, in radians. Source: LinuxCNC, where it is a round number in
/// the unit of the program.
[[nodiscard]] double sweepTolerance(bool inch);

/// Whether an offset path that is to lead from `start` to `end` still goes forward.
[[nodiscard]] bool goesForward(const PlanePath& path, const Vec2& start, const Vec2& end, double tolerance);

} // namespace proveout
