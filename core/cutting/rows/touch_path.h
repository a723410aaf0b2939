// SPDX-License-Identifier: GPL-3.0-or-later
// When a cutter on a straight path first touches a column of material.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/base/geometry.h"
#include "core/cutter/cutter.h"
#include "core/cutting/profiles/convex_profile.h"
#include "core/cutting/profiles/row_points.h"
#include "core/cutting/rows/straight_sweep.h"

namespace proveout {

/// The straight path of a cutter's tip. Times are fractions of it, from 0 at its start to 1 at its end; above
/// the rim the cutter is an endless cylinder. `grown`: the cutter is larger by that on all sides in plan, so
/// that it touches no later. Immutable; any thread.
class TouchPath {
public:
    static constexpr double kNever = std::numeric_limits<double>::infinity();

    TouchPath(const Cutter& cutter, const Vec3& start, const Vec3& end, double grown = 0);

    /// The first time at which the cutter is not above a column of this height at a place in plan; kNever if
    /// there is none.
    [[nodiscard]] double firstTouch(const Vec2& place, double height) const;
    /// The part of the row y = const that the cutter passes over.
    [[nodiscard]] Span rowSpan(double y) const;
    /// The range of y that it passes over.
    [[nodiscard]] Span rows() const;
    /// The lowest height that any part of it reaches.
    [[nodiscard]] double lowest() const;
    [[nodiscard]] double length() const { return m_length; } ///< mm
    [[nodiscard]] Vec3 at(double time) const { return m_start + (m_end - m_start) * time; }

private:
    [[nodiscard]] double firstTouch(const ConvexProfile& profile, const Vec2& place, double height) const;
    [[nodiscard]] double firstTouchPlunging(const ConvexProfile& profile, double distance,
                                            double height) const;

    std::vector<ConvexProfile> m_profiles;
    Vec3 m_start;
    Vec3 m_end;
    double m_length;
    StraightPath m_path; ///< relative to the start, in plan
    double m_rim = 0;
};

} // namespace proveout
