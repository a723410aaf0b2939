// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/cutting/kernels/curve_pass.h"
#include "core/cutting/kernels/round_pass.h"
#include "core/cutting/kernels/straight_pass.h"
#include "core/cutting/profiles/level_profile.h"

namespace proveout {

/// One motion for the inner loops over a grid: the passes along the path for each of the cutter's profiles.
/// Immutable; any thread.
class SweepPasses {
public:
    SweepPasses() = default; ///< none
    /// Empty if single precision does not suffice.
    SweepPasses(std::span<const ConvexProfile> profiles, const StraightPath& path,
                const TileSpacing& spacing);
    /// A whole profile on a level path.
    SweepPasses(const std::shared_ptr<const LevelProfile>& whole, const StraightPath& path,
                const TileSpacing& spacing);
    SweepPasses(const std::shared_ptr<const LevelProfile>& whole, const ArcPath& path,
                const TileSpacing& spacing);
    SweepPasses(std::span<const ConvexProfile> profiles, const ArcPath& path, const TileSpacing& spacing);
    /// Also empty if it costs less to cut hollows as lines.
    SweepPasses(const HollowedProfiles& profiles, const StraightPath& path, const TileSpacing& spacing);
    SweepPasses(const HollowedProfiles& profiles, const ArcPath& path, const TileSpacing& spacing);

    [[nodiscard]] bool empty() const { return m_straight.empty() && m_round.empty() && !m_curve; }
    /// The largest work on one point, as a multiple of that on a point of a straight motion.
    [[nodiscard]] double costOfPoint() const;
    /// Adds the passes that may reach the tile with its middle at (x, y), in the path's coordinates.
    void addOverTile(double x, double y, const TileSpacing& spacing, std::vector<TilePass>& passes) const;

private:
    /// False if one of them does not suffice after all.
    template<class Profile>
    [[nodiscard]] bool addRound(std::span<const Profile> profiles, const ArcPath& path);
    [[nodiscard]] bool addStraight(std::span<const HollowProfile> profiles, const StraightPath& path);

    std::vector<StraightPass> m_straight;
    std::vector<RoundPass> m_round;
    std::optional<CurvePass> m_curve;
};

} // namespace proveout
