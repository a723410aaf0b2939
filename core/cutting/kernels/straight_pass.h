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

/// Of a grid.
struct TileSpacing {
    double hx;
    double hy;
    double tileReach;  ///< from a tile's middle to its corners
    double blockReach; ///< from a block's middle to its corners

    TileSpacing(double x, double y)
        : hx(x), hy(y), tileReach(std::hypot(x, y) * (Tile::kSize - 1) / 2),
          blockReach(std::hypot(x, y) * (Tile::kBlockSize - 1) / 2) {}
};

/// Makes a pass of the line below a hollow one of the hollow.
void setHollow(TilePass& form, const HollowProfile& hollow);

/// One profile on one straight path, ready to be seen from any tile of a grid. Immutable; any thread.
class StraightPass {
public:
    StraightPass(const ConvexProfile& profile, const StraightPath& path);

    /// A whole profile on a level path.
    StraightPass(std::shared_ptr<const LevelProfile> whole, const StraightPath& path);

    /// A hollow on a path that is not level; of no use without its leads.
    StraightPass(const HollowProfile& hollow, const StraightPath& path);

    /// Whether single precision tells the envelope over a grid to a ten thousandth of a millimetre. Very
    /// large cutters, wide grids and near plunges want more digits.
    [[nodiscard]] static bool suffices(const ConvexProfile& profile, const StraightPath& path,
                                       const TileSpacing& spacing);

    /// What a pass of this slope is on any path and over any tile.
    [[nodiscard]] static TilePass formOf(const ConvexProfile& profile, const StraightPath& path);

    /// Finds leads once for all points, which is worth it for many; false where they cannot be told so. See
    /// LeadBands.
    bool fitLeads();

    /// Seen from the tile whose middle lies at (x, y), in the path's coordinates; not beyond this one's life.
    [[nodiscard]] TilePass overTile(double x, double y, const TileSpacing& spacing) const;

private:
    StraightPath m_path;
    double m_rim;
    double m_reference; ///< of the profile's heights
    TilePass m_form;    ///< what does not depend on the place
    std::shared_ptr<const LevelProfile> m_whole;
    std::shared_ptr<const LeadBands> m_bands;
};

} // namespace proveout
