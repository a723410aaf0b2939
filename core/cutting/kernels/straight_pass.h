// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>

#include "core/cutting/kernels/lead_bands.h"
#include "core/cutting/kernels/tile_pass.h"
#include "core/cutting/profiles/hollow_profile.h"
#include "core/cutting/profiles/level_profile.h"
#include "core/cutting/rows/straight_sweep.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The spacing of a grid.
struct TileSpacing {
    double hx;
    double hy;
    double tileReach;  ///< from a tile's middle to its corners
    double blockReach; ///< from a block's middle to its corners

    TileSpacing(double x, double y)
        : hx(x), hy(y), tileReach(std::hypot(x, y) * (Tile::kSize - 1) / 2),
          blockReach(std::hypot(x, y) * (Tile::kBlockSize - 1) / 2) {}
};

/// Turns the pass of the line below a hollow into one of the hollow itself.
void setHollow(TilePass& form, const HollowProfile& hollow);

/// One profile on one straight path, from which the pass over any tile of a grid can be made. Immutable; any
/// thread.
class StraightPass {
public:
    StraightPass(const ConvexProfile& profile, const StraightPath& path);

    /// A whole profile on a level path.
    StraightPass(std::shared_ptr<const LevelProfile> whole, const StraightPath& path);

    /// A hollow; on a path that is neither level nor along the grid it cannot be used without its leads.
    StraightPass(const HollowProfile& hollow, const StraightPath& path);

    /// A hollow at the lower end of the path alone, and where a point leaves its rim on the way.
    [[nodiscard]] static StraightPass atLowerEnd(const HollowProfile& hollow, const StraightPath& path);

    /// Whether single precision gives the envelope over a grid to a ten-thousandth of a millimetre. Very
    /// large cutters, wide grids and near-plunges need more digits.
    [[nodiscard]] static bool suffices(const ConvexProfile& profile, const StraightPath& path,
                                       const TileSpacing& spacing);

    /// The values of a pass that depend only on the profile and the slope.
    [[nodiscard]] static TilePass formOf(const ConvexProfile& profile, const StraightPath& path);

    /// Fits the leads once for all points, which pays off for many points; false if they cannot be
    /// approximated. See LeadBands.
    bool fitLeads();

    /// Whether a point of the tile with its middle at (x, y) may be under the cutter, as far as the start of
    /// the path decides that.
    [[nodiscard]] bool reachesBeyondStart(double x, double y, const TileSpacing& spacing) const;
    /// The pass over the tile with its middle at (x, y), in the path's coordinates; it must not outlive this
    /// object.
    [[nodiscard]] TilePass overTile(double x, double y, const TileSpacing& spacing) const;

private:
    [[nodiscard]] double alongAt(double x, double y) const;
    [[nodiscard]] double overlap(const TileSpacing& spacing) const;
    /// At least how far ahead of a point it may be when it is lowest over it, mm.
    [[nodiscard]] double largestLead() const;

    StraightPath m_path;
    double m_rim;
    double m_reference; ///< of the profile's heights
    TilePass m_form;    ///< the values that do not depend on the tile
    std::shared_ptr<const LevelProfile> m_whole;
    std::shared_ptr<const LeadBands> m_bands;
};

} // namespace proveout
