// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/changed_regions.h"

#include <algorithm>
#include <cassert>

namespace proveout {

namespace {

bool sameRows(const Tile& a, const Tile& b, const IndexRect& inTile) {
    for (int j = inTile.j0; j < inTile.j1; ++j) {
        const auto* first = a.heights.data() + static_cast<std::size_t>(j * Tile::kSize);
        const auto* second = b.heights.data() + static_cast<std::size_t>(j * Tile::kSize);
        if (!std::equal(first + inTile.i0, first + inTile.i1, second + inTile.i0))
            return false;
    }
    return true;
}

} // namespace

bool sameHeights(const ZMap& zmap, const ZMapSnapshot& moment, const IndexRect& rect) {
    assert(zmap.grid() == moment.grid());
    if (rect.empty())
        return true;
    for (int tj = rect.j0 / Tile::kSize; tj <= (rect.j1 - 1) / Tile::kSize; ++tj)
        for (int ti = rect.i0 / Tile::kSize; ti <= (rect.i1 - 1) / Tile::kSize; ++ti) {
            const auto index = static_cast<std::size_t>(tj * zmap.tilesX() + ti);
            const Tile& now = zmap.tile(index);
            const Tile& then = *moment.tile(index);
            if (&now == &then)
                continue;
            const int i = ti * Tile::kSize;
            const int j = tj * Tile::kSize;
            const IndexRect inTile{std::max(rect.i0 - i, 0), std::max(rect.j0 - j, 0),
                                   std::min(rect.i1 - i, Tile::kSize), std::min(rect.j1 - j, Tile::kSize)};
            if (!sameRows(now, then, inTile))
                return false;
        }
    return true;
}

std::vector<std::size_t> differingRegions(const ZMapSnapshot& a, const ZMapSnapshot& b,
                                          const RegionGrid& grid) {
    assert(a.grid() == b.grid());
    std::vector<bool> candidate(grid.regionCount(), false);
    std::vector<bool> otherWalls(grid.regionCount(), false);
    for (std::size_t tile = 0; tile < a.tileCount(); ++tile) {
        const bool sameWalls = a.walls().tile(tile) == b.walls().tile(tile);
        if (a.tile(tile) == b.tile(tile) && sameWalls)
            continue;
        const IndexRect regions = grid.regionsTouching(a.tileRect(tile));
        for (int ry = regions.j0; ry < regions.j1; ++ry)
            for (int rx = regions.i0; rx < regions.i1; ++rx)
                (sameWalls ? candidate : otherWalls)[grid.regionAt(rx, ry)] = true;
    }
    std::vector<std::size_t> differing;
    for (std::size_t region = 0; region < candidate.size(); ++region)
        if (otherWalls[region] || (candidate[region] && !a.sameHeights(b, grid.points(region))))
            differing.push_back(region);
    return differing;
}

void touchChanged(Surface& surface, const ZMap& zmap, const ZMapSnapshot& base, const IndexRect& changed) {
    if (surface.dirtyRegions() == surface.grid().regionCount())
        return;
    forChangedRegions(
        zmap, base, changed, surface.grid(), [&](std::size_t region) { return surface.isDirty(region); },
        [&](std::size_t region) { surface.touchRegion(region); });
}

} // namespace proveout
