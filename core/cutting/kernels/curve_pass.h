// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cutting/kernels/straight_pass.h"
#include "core/cutting/profiles/arc_path.h"
#include "core/cutting/profiles/convex_profile.h"

namespace proveout {

/// One convex profile on any arc, as straight pieces that deviate from it by 4e-5 mm at most, equally on both
/// sides. They are computed again for each tile, because an arc may have thousands. Immutable; any thread.
class CurvePass {
public:
    CurvePass(const ConvexProfile& profile, const ArcPath& path);

    /// Whether that many pieces are worth it, and single precision suffices for cutter and grid.
    [[nodiscard]] static bool suffices(const ConvexProfile& profile, const ArcPath& path,
                                       const TileSpacing& spacing);

    /// Adds the pieces that may reach the tile with its middle at (x, y), starting with pieces far apart:
    /// once the arc is cut roughly, most other pieces are above the surface except where they touch.
    void addOverTile(double x, double y, const TileSpacing& spacing, std::vector<TilePass>& passes) const;

private:
    ConvexProfile m_profile;
    ArcPath m_path; ///< slightly widened, so that the pieces deviate to both sides
    int m_pieces;
    double m_bulge;
};

} // namespace proveout
