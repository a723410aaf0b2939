// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/cutting/kernels/straight_pass.h"
#include "core/cutting/profiles/arc_path.h"
#include "core/cutting/profiles/convex_profile.h"
#include "core/cutting/profiles/hollow_profile.h"

namespace proveout {

/// Convex and hollow profiles on any arc, as straight pieces that deviate from it by 4e-5 mm at most, equally
/// on both sides. They are computed again for each tile, because an arc may have thousands. Immutable; any
/// thread.
class CurvePass {
public:
    CurvePass(std::span<const ConvexProfile> profiles, const ArcPath& path);
    CurvePass(const HollowedProfiles& profiles, const ArcPath& path);

    /// Whether that many pieces are worth it, and single precision suffices for cutter and grid.
    [[nodiscard]] static bool suffices(const ConvexProfile& profile, const ArcPath& path,
                                       const TileSpacing& spacing);
    /// Only arcs; hollows are cut at the ends of pieces.
    [[nodiscard]] static bool allSuffice(const HollowedProfiles& profiles, const ArcPath& path,
                                         const TileSpacing& spacing);

    /// Adds the pieces that may reach the tile with its middle at (x, y), starting with pieces far apart:
    /// once the arc is cut roughly, most other pieces are above the surface except where they touch. The
    /// profiles of a piece follow each other.
    void addOverTile(double x, double y, const TileSpacing& spacing, std::vector<TilePass>& passes) const;

    [[nodiscard]] std::size_t profileCount() const { return m_profiles.size() + m_hollows.size(); }

private:
    /// The ends of the pieces.
    [[nodiscard]] std::vector<Vec3> places() const;

    std::vector<ConvexProfile> m_profiles;
    std::vector<HollowProfile> m_hollows;
    std::vector<HollowProfile> m_steep; ///< their steep parts
    double m_rim = 0;                   ///< the largest
    ArcPath m_path;
    int m_pieces;
};

} // namespace proveout
