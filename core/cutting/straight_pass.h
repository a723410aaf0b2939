// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cutting/block_pass.h"
#include "core/cutting/straight_sweep.h"

namespace proveout {

/// One convex profile on one straight path, ready to be seen from any block of a grid. Immutable; any thread.
class StraightPass {
public:
    /// `hx`, `hy`: the spacing of the grid.
    StraightPass(const ConvexProfile& profile, const StraightPath& path, double hx, double hy);

    /// Whether single precision tells the envelope to a ten thousandth of a millimetre. Very large cutters,
    /// wide grids and near plunges want more digits.
    [[nodiscard]] static bool suffices(const ConvexProfile& profile, const StraightPath& path, double hx,
                                       double hy);

    /// Seen from the block whose first point lies at (x, y), in the path's coordinates.
    [[nodiscard]] BlockPass overBlock(double x, double y) const;
    /// For blocksBelow(), seen from the tile whose first point lies at (x, y).
    [[nodiscard]] BlockPass overTile(double x, double y) const;
    /// What computing in single precision may add to a bound or take from a height, mm; 0 where it may not.
    [[nodiscard]] float slack() const { return m_slack; }

private:
    [[nodiscard]] BlockPass seenFrom(const BlockPass& form, double rim, double extent, double x,
                                     double y) const;

    StraightPath m_path;
    double m_hx;
    double m_hy;
    double m_rim;
    double m_extent; ///< of a block: from its first point to the opposite corner
    double m_reference;
    BlockPass m_form;    ///< what does not depend on the place
    BlockPass m_dilated; ///< the same of the dilated profile
    float m_slack = 0;
};

} // namespace proveout
