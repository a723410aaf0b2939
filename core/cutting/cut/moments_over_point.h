// SPDX-License-Identifier: GPL-3.0-or-later
// When, on one motion, the cutter and another part of its tool are over one point.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/cutting/profiles/convex_profile.h"
#include "core/cutting/rows/straight_sweep.h"
#include "core/nc/program/motion.h"

namespace proveout {

/// Follows the motion over a point: until the cutter comes over it, the material has its height of before;
/// while the cutter is over it, it is below everything that is above the cutter; afterwards it has the height
/// that the cutter left. Arcs count as chords that are nowhere farther from them than kChordError, unless
/// more than kMostLegs of them would be needed. Keeps references; one thread.
class MomentsOverPoint {
public:
    static constexpr std::size_t kMostLegs = 100'000;

    /// `cutter`: its profiles, without slack at the rim; `cutterRadius`: its largest radius; `floorZ`: there
    /// is no material below it.
    MomentsOverPoint(std::span<const ConvexProfile> cutter, double cutterRadius, const Motion& motion,
                     double floorZ)
        : m_profiles(cutter), m_cutterRadius(cutterRadius), m_motion(motion), m_floorZ(floorZ) {}

    /// The largest height by which the material is above a part at any moment, or 0; `part`: its profiles,
    /// within `radius`; `height` of the material before the motion, absolute. Nothing if the cutter never
    /// comes over the point, so that the material keeps its height.
    [[nodiscard]] std::optional<double> deepest(std::span<const ConvexProfile> part, double radius,
                                                const Vec2& point, double height);

private:
    /// Some legs that follow each other, and the box of their path over ground.
    struct Run {
        Vec2 lo;
        Vec2 hi;
        std::size_t end; ///< of its legs
    };
    void prepare();
    void addLegs(std::size_t count);

    std::span<const ConvexProfile> m_profiles;
    double m_cutterRadius;
    const Motion& m_motion;
    double m_floorZ;
    std::vector<ConvexProfile> m_cutter; ///< with slack at the rim; empty: not prepared yet
    Vec2 m_origin{0};
    std::vector<StraightPath> m_legs; ///< relative to m_origin, heights absolute
    std::vector<Run> m_runs;
};

} // namespace proveout
