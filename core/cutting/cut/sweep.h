// SPDX-License-Identifier: GPL-3.0-or-later
// One motion of one cutter, prepared for evaluation row by row.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/cutting/kernels/sweep_passes.h"
#include "core/cutting/profiles/hollow_profile.h"
#include "core/cutting/profiles/level_profile.h"
#include "core/cutting/profiles/row_points.h"
#include "core/cutting/rows/arc_sweep.h"
#include "core/cutting/rows/edge_crossing.h"
#include "core/cutting/rows/straight_sweep.h"
#include "core/nc/program/motion.h"

namespace proveout {

/// How far beyond its rim a cutter cuts, so that a point exactly on the rim is cut whichever way its distance
/// is rounded: a thousandth of a nanometre, or more where coordinates are so large that a double has less
/// precision.
[[nodiscard]] double rimSlack(const Motion& motion);

/// The swept volume. Arguments are in program coordinates over ground, and heights are relative to `topZ`;
/// internally coordinates are relative to the motion's start, so that precision does not depend on the
/// position of the stock. Immutable; any thread.
class Sweep {
public:
    Sweep() = default; ///< empty
    /// Empty if the path is unknown or not finite, or the cutter has no profile. `topZ` becomes height 0.
    /// `continues`: as in CutterMotion.
    Sweep(const Cutter& cutter, const Motion& motion, double topZ, bool continues = false);

    [[nodiscard]] bool empty() const { return m_profiles.empty(); }
    /// The box of everything that the cutter may touch.
    [[nodiscard]] const Box3& reach() const { return m_reach; }
    /// The lowest height that the cutter reaches anywhere.
    [[nodiscard]] double lowest() const { return m_reach.lo.z; }

    /// The origin of the coordinates of passes(), over ground.
    [[nodiscard]] Vec2 origin() const { return Vec2(m_origin); }
    /// The passes of the motion for the inner loops over a grid. Empty if single precision does not suffice.
    [[nodiscard]] SweepPasses passes(double hx, double hy) const;

    /// The largest work on one point if there are no passes, as a multiple of that on a point of a straight
    /// motion.
    [[nodiscard]] double costOfPoint() const;

    /// The part of the band y0 <= y <= y1 that may be under the cutter.
    [[nodiscard]] Span bandSpan(double y0, double y1) const;

    /// The envelope over one point; +infinity where the cutter never comes. If it is not below `known`, any
    /// height that is not either.
    [[nodiscard]] double envelope(double x, double y,
                                  double known = std::numeric_limits<double>::infinity()) const;
    /// The distance of a point from the path over ground, mm, positive to the left of it.
    [[nodiscard]] double beside(const Vec2& point) const;
    /// Updates `first` by the first place where the envelope is below the line, as findCrossing().
    void findCrossing(const EdgeLine& line, EdgeCrossing& first) const;
    /// Writes the envelope over a row of points into `out`, which holds +infinity. Returns the points that
    /// were evaluated; all others keep their infinity. `heights` are those of the z-map: points that surely
    /// keep theirs may be skipped.
    Columns row(const RowPoints& row, const float* heights, float* out) const;

private:
    [[nodiscard]] Columns straightColumns(const RowPoints& row, float* out) const;
    [[nodiscard]] Columns arcColumns(const RowPoints& row, const float* heights, float* out) const;

    [[nodiscard]] bool level() const;
    [[nodiscard]] double levelEnvelope(const Vec2& point) const;
    [[nodiscard]] double roundEnvelope(const Vec2& point, double known) const;

    std::vector<ConvexProfile> m_profiles;
    std::shared_ptr<const LevelProfile> m_whole; ///< of lines and circles at one height
    std::optional<HollowedProfiles> m_hollowed;  ///< of other paths; `m_profiles` has lines in place of their
                                                 ///< hollows
    Vec3 m_origin{0};
    bool m_arc = false;
    StraightPath m_straight;
    ArcPath m_path;
    std::vector<ArcPart> m_parts;
    double m_rim = 0;
    Box3 m_reach;
};

} // namespace proveout
