// SPDX-License-Identifier: GPL-3.0-or-later
// A motion: the straight or circular path of the tool control point that one block programs.
#pragma once

#include <cstdint>

#include "core/base/geometry.h"

namespace proveout {

enum class MotionKind : std::uint8_t { rapid, feed, arc };

/// The plane of an arc; its normal is +Z, +Y, +X.
enum class Plane : std::uint8_t {
    xy, ///< G17
    zx, ///< G18: counter-clockwise as seen from +Y
    yz, ///< G19
};

/// One bit per axis; set if the position of that axis is known and not assumed.
enum AxisBits : std::uint8_t { kAxisX = 1, kAxisY = 2, kAxisZ = 4, kAllAxes = 7 };
/// `axis`: 0 to 2.
[[nodiscard]] constexpr std::uint8_t axisBit(int axis) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(axis));
}
/// X, Y, Z.
[[nodiscard]] constexpr char letterOfAxis(int axis) {
    return static_cast<char>('X' + axis);
}

/// Program coordinates in mm, of the tip of the cutter. Value type.
struct Motion {
    MotionKind kind = MotionKind::rapid;
    Plane plane = Plane::xy;
    std::uint8_t startKnown = 0; ///< AxisBits of `start`
    std::uint8_t endKnown = 0;   ///< AxisBits of `end`
    /// Z is unknown, but at the machine's reference position: clear of the part, as every program assumes.
    bool startAtReference = false;
    bool endAtReference = false;
    bool unverified = false; ///< follows something that was not understood
    bool probing = false;    ///< stops at the stock instead of cutting it
    int tool = 0;            ///< number of the tool in the spindle, 0: none
    std::uint32_t line = 0;  ///< source line, 1-based
    Vec3 start{0};
    Vec3 end{0};
    Vec3 centre{0};          ///< arcs: on the level of the start point
    double sweep = 0;        ///< arcs: signed angle about the plane's normal, right-handed; may exceed a turn
    double feedMmPerMin = 0; ///< 0 for rapids and if no feed was given
    bool perRevolution = false; ///< the feed was given per revolution of the spindle
    double spindleRpm = 0;      ///< signed: positive clockwise (M3), 0 stopped
    double orderedRpm = 0;      ///< as programmed by S, also while the spindle is stopped

    /// Whether the whole path is known, so that it may cut.
    [[nodiscard]] bool known() const { return (startKnown & endKnown) == kAllAxes; }
};

/// Axis indices (0 x, 1 y, 2 z) of a plane: first and second axis, right-handed about the normal axis.
struct PlaneAxes {
    int first;
    int second;
    int normal;
};
[[nodiscard]] PlaneAxes axes(Plane plane);
/// A point without its coordinate along the normal.
[[nodiscard]] Vec2 inPlane(const Vec3& point, const PlaneAxes& plane);
/// `point` moved to another place in the plane.
[[nodiscard]] Vec3 withPlane(Vec3 point, const Vec2& place, const PlaneAxes& plane);

/// Distance of the start point from the arc's centre, in its plane.
[[nodiscard]] double arcRadius(const Motion& motion);

/// The point at `t` in [0, 1]; the radius of an arc whose ends differ changes linearly from one to the other,
/// and t = 1 gives `end` exactly.
[[nodiscard]] Vec3 pointAt(const Motion& motion, double t);

/// Length of the path in mm.
[[nodiscard]] double pathLength(const Motion& motion);

/// The largest deviation, in mm, of a curve that is neither a line nor an arc in a plane of the machine from
/// the straight motions that replace it: no point of it is farther from the line between the ends of its
/// piece, and these ends are on it. A control rounds more than that.
inline constexpr double kChordError = 1e-3;

/// The limits of an arc: no motion that a machine can run exceeds them, and the work on an arc grows with
/// both.
inline constexpr double kLongestArc = 1e7; ///< mm of path
inline constexpr int kMostTurns = 1000;
/// Whether a motion is within them; straight ones always are. The interpreter refuses the others with a
/// message, and `cut` relies on that.
[[nodiscard]] bool withinLimits(const Motion& motion);

/// The box of the path.
[[nodiscard]] Box3 bounds(const Motion& motion);

} // namespace proveout
