// SPDX-License-Identifier: GPL-3.0-or-later
// One motion of one cutter, made ready for being asked row by row.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/cutting/kernels/sweep_passes.h"
#include "core/cutting/profiles/hollow_profile.h"
#include "core/cutting/profiles/level_profile.h"
#include "core/cutting/profiles/row_points.h"
#include "core/cutting/rows/arc_sweep.h"
#include "core/cutting/rows/straight_sweep.h"
#include "core/nc/program/motion.h"

namespace proveout {

/// The swept volume. Asked in program coordinates over ground and heights relative to `topZ`; inside it works
/// relative to the motion's start, so that precision does not depend on where the stock lies. Immutable; any
/// thread.
class Sweep {
public:
    Sweep() = default; ///< nothing
    /// Nothing where the path is not known, not finite, or the cutter has no profile. `topZ` becomes height
    /// 0.
    Sweep(const Cutter& cutter, const Motion& motion, double topZ);

    [[nodiscard]] bool empty() const { return m_profiles.empty(); }
    /// The box of all that the cutter may touch.
    [[nodiscard]] const Box3& reach() const { return m_reach; }
    /// The lowest height that the cutter reaches anywhere.
    [[nodiscard]] double lowest() const { return m_reach.lo.z; }

    /// Where the coordinates of passes() begin, over ground.
    [[nodiscard]] Vec2 origin() const { return Vec2(m_origin); }
    /// The motion as inner loops see it over a grid. None where single precision does not suffice.
    [[nodiscard]] SweepPasses passes(double hx, double hy) const;

    /// The work on one point at most where there are no passes, as a multiple of that on a point of a
    /// straight motion.
    [[nodiscard]] double costOfPoint() const;

    /// The part of the band y0 <= y <= y1 that may lie under the cutter.
    [[nodiscard]] Span bandSpan(double y0, double y1) const;

    /// The envelope over one point; +infinity where the cutter never comes.
    [[nodiscard]] double envelope(double x, double y) const;
    /// How far beside the path a point lies over ground, mm, left of it positive.
    [[nodiscard]] double beside(const Vec2& point) const;
    /// The envelope over a row of points into `out`, which holds +infinity. Returns the points that were
    /// asked; all others keep their infinity. `heights` are those of the z-map: points that surely stay at
    /// theirs may be left out.
    Columns row(const RowPoints& row, const float* heights, float* out) const;

private:
    [[nodiscard]] Columns straightColumns(const RowPoints& row, float* out) const;
    [[nodiscard]] Columns arcColumns(const RowPoints& row, const float* heights, float* out) const;

    [[nodiscard]] bool level() const;
    [[nodiscard]] double levelEnvelope(const Vec2& point) const;

    std::vector<ConvexProfile> m_profiles;
    std::shared_ptr<const LevelProfile> m_whole; ///< of lines and circles at one height
    std::optional<HollowedProfiles> m_hollowed;  ///< of others; `m_profiles` has lines for their hollows
    Vec3 m_origin{0};
    bool m_arc = false;
    StraightPath m_straight;
    ArcPath m_path;
    std::vector<ArcPart> m_parts;
    double m_rim = 0;
    Box3 m_reach;
};

} // namespace proveout
