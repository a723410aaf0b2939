// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry of cutter compensation: paths beside a path, and how they are joined. In one plane, lengths in
// mm; pure functions. An `offset` is the tool's radius, positive if the tool is to the left of the path.
// Source: the behaviour of LinuxCNC's interpreter, determined by running it.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/geometry.h"

namespace proveout {

/// A motion shorter than this in the plane, in mm, does not count as a motion there.
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

/// The point beside `point` for a path that passes with `heading`.
[[nodiscard]] Vec2 beside(const Vec2& point, const Vec2& heading, double offset);

/// Whether the tool moves around an arc on the side away from its centre.
[[nodiscard]] bool roundOutside(const PlanePath& arc, double offset);

/// The path at the distance of the tool's radius. Nothing if the tool does not fit into the arc.
[[nodiscard]] std::optional<PlanePath> offsetPath(const PlanePath& path, double offset);

/// The lead-in motion: from its start, where the tool is on the path, to the point at a right angle beside
/// its end. An arc gets another radius about a centre on the spoke of its end, or beyond that end.
[[nodiscard]] PlanePath entryPath(const PlanePath& path, double offset);

enum class CornerKind : std::uint8_t {
    tangent, ///< nearly straight: the tool continues from where it is
    outside, ///< the tool rolls around the corner
    inside,  ///< both paths end where they meet
};
struct Corner {
    CornerKind kind;
    double sweep; ///< outside: of the arc around the corner
};
/// The connection between two offset paths; `heading` is the programmed one at the end of the first, which
/// may differ from that of a lead-in motion.
[[nodiscard]] Corner cornerBetween(const PlanePath& before, const Vec2& heading, const PlanePath& after,
                                   double offset);

/// Where two offset paths of an inside corner meet; they may be lengthened for that. Nothing if they do not
/// meet.
[[nodiscard]] std::optional<Vec2> meetingPoint(const PlanePath& before, const PlanePath& after,
                                               double offset);

/// The sweep of an arc with its ends moved: in its direction, with its full turns.
[[nodiscard]] double sweepBetween(const PlanePath& arc, const Vec2& start, const Vec2& end);

/// How much longer an arc may become at its ends, in radians. Source: LinuxCNC, where it is a round number in
/// the unit of the program.
[[nodiscard]] double sweepTolerance(bool inch);

/// Whether an offset path from `start` to `end` still runs forward.
[[nodiscard]] bool goesForward(const PlanePath& path, const Vec2& start, const Vec2& end, double tolerance);

} // namespace proveout
