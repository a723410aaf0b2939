// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/decimation/regions/region_grid.h"
#include "core/decimation/surface/surface.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Whether the z-map has the heights of an earlier snapshot in a rectangle of points. Tiles that both share
/// are not compared.
[[nodiscard]] bool sameHeights(const ZMap& zmap, const ZMapSnapshot& moment, const IndexRect& rect);

/// Calls visit(region) for the regions, ascending, in which points of `changed` differ from an earlier
/// snapshot; regions with skip(region) are passed over. The box of a slanted motion holds regions that it
/// never touched: only changed heights count.
template<class Skip, class Visit>
void forChangedRegions(const ZMap& zmap, const ZMapSnapshot& moment, const IndexRect& changed,
                       const RegionGrid& grid, const Skip& skip, const Visit& visit) {
    if (changed.empty())
        return;
    const IndexRect regions = grid.regionsTouching(changed);
    for (int ry = regions.j0; ry < regions.j1; ++ry)
        for (int rx = regions.i0; rx < regions.i1; ++rx) {
            const std::size_t region = grid.regionAt(rx, ry);
            if (!skip(region) && !sameHeights(zmap, moment, intersection(grid.points(region), changed)))
                visit(region);
        }
}

/// The regions, ascending, whose heights or walls differ between two snapshots of one grid. Only regions in
/// tiles that the snapshots do not share are compared.
[[nodiscard]] std::vector<std::size_t> differingRegions(const ZMapSnapshot& a, const ZMapSnapshot& b,
                                                        const RegionGrid& grid);

/// Touches the regions that have changed since `base`, of those within `changed`. (The box of a slanted
/// motion holds regions that it never touched: only changed heights count.)
void touchChanged(Surface& surface, const ZMap& zmap, const ZMapSnapshot& base, const IndexRect& changed);

} // namespace proveout
