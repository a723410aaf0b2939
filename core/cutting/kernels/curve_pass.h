// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cutting/kernels/straight_pass.h"
#include "core/cutting/profiles/arc_path.h"
#include "core/cutting/profiles/convex_profile.h"

namespace proveout {

/// One convex profile on any arc, as straight pieces that leave it by a hundred-thousandth of a millimetre
/// at most, on both sides alike. They are made anew for each tile: an arc may have thousands. Immutable; any
/// thread.
class CurvePass {
public:
    CurvePass(const ConvexProfile& profile, const ArcPath& path);

    /// Whether that many pieces are worth it, and single precision suffices for cutter and grid.
    [[nodiscard]] static bool suffices(const ConvexProfile& profile, const ArcPath& path,
                                       const TileSpacing& spacing);

    /// Adds those that may reach the tile whose middle lies at (x, y), far ones of them first: with the arc
    /// cut roughly, most others are above it but where they touch.
    void addOverTile(double x, double y, const TileSpacing& spacing, std::vector<TilePass>& passes) const;

private:
    ConvexProfile m_profile;
    ArcPath m_path; ///< a little wider, so that pieces lie on both sides
    int m_pieces;
    double m_bulge;
};

} // namespace proveout
