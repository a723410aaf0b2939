// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/cutting/kernels/lead_bands.h"
#include "core/cutting/kernels/straight_pass.h"
#include "core/cutting/kernels/tile_pass.h"
#include "core/cutting/profiles/arc_path.h"
#include "core/cutting/profiles/convex_profile.h"
#include "core/cutting/profiles/level_profile.h"

namespace proveout {

/// One convex profile on a part of an arc, helix or narrow spiral about Z, from which the pass over any tile
/// of a grid can be made. Immutable; any thread.
class RoundPass {
public:
    /// The part from `begin` to `end` of the path, at most a turn.
    RoundPass(const ConvexProfile& profile, const ArcPath& path, double begin, double end);

    /// Whether single precision gives the envelope over a grid to a ten-thousandth of a millimetre, for paths
    /// about Z that widen and climb little.
    [[nodiscard]] static bool suffices(const ConvexProfile& profile, const ArcPath& path,
                                       const TileSpacing& spacing);
    /// The passes that make up a path, the lowest first.
    [[nodiscard]] static std::vector<RoundPass> allOf(const ConvexProfile& profile, const ArcPath& path);
    /// A whole profile on a level path.
    [[nodiscard]] static std::vector<RoundPass> allOf(const std::shared_ptr<const LevelProfile>& whole,
                                                      const ArcPath& path);

    /// A hollow on a path that climbs; cannot be used without its leads.
    [[nodiscard]] static std::vector<RoundPass> allOf(const HollowProfile& hollow, const ArcPath& path);

    /// Call it for all parts of a path that climbs. False if leads cannot be given by bands: these passes
    /// cannot be used then.
    [[nodiscard]] static bool fitLeads(std::span<RoundPass> parts);

    /// The pass over the tile with its middle at (x, y), in the path's coordinates; it must not outlive this
    /// object.
    [[nodiscard]] TilePass overTile(double x, double y, const TileSpacing& spacing) const;

private:
    Vec2 m_centre;
    Vec2 m_towards; ///< unit vector from the centre to the middle of the part
    double m_radius;
    double m_half; ///< as in TilePass::Round, but in double
    double m_widening;
    double m_rim;
    double m_z;     ///< of the profile's reference at the middle
    double m_slope; ///< of the path
    TilePass m_form;
    std::shared_ptr<const LevelProfile> m_whole;
    std::shared_ptr<const LeadBands> m_bands;
};

} // namespace proveout
