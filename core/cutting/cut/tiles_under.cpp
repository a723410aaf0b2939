// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/tiles_under.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// First and last tile along one axis that [lo, hi] may touch; computed in double, as a motion may reach
/// farther than any index. Empty if first > last.
struct TileRange {
    int first;
    int last;
};

TileRange tilesUnder(double lo, double hi, double origin, double spacing, int points) {
    const double begin = std::ceil((lo - origin) / spacing - 1e-6);
    const double end = std::floor((hi - origin) / spacing + 1e-6);
    if (!(begin <= end) || !(end >= 0) || !(begin <= points - 1))
        return {0, -1};
    return {static_cast<int>(std::max(begin, 0.0)) / Tile::kSize,
            static_cast<int>(std::min(end, points - 1.0)) / Tile::kSize};
}

} // namespace

void tilesToLower(const ZMap& zmap, const Sweep& sweep, std::vector<std::size_t>& tiles) {
    const Grid& grid = zmap.grid();
    const Box3& reach = sweep.reach();
    const TileRange rows = tilesUnder(reach.lo.y, reach.hi.y, grid.y0, grid.hy, grid.ny);
    for (int tj = rows.first; tj <= rows.last; ++tj) {
        const double y0 = grid.y(tj * Tile::kSize);
        const Span span = sweep.bandSpan(y0, y0 + (Tile::kSize - 1) * grid.hy);
        const TileRange columns = tilesUnder(span.lo, span.hi, grid.x0, grid.hx, grid.nx);
        for (int ti = columns.first; ti <= columns.last; ++ti) {
            const auto index = static_cast<std::size_t>(tj) * static_cast<std::size_t>(zmap.tilesX()) +
                               static_cast<std::size_t>(ti);
            // A tile that is entirely below the cutter, or entirely on the floor, cannot change.
            const float maximum = zmap.tile(index).maximum;
            if (static_cast<double>(maximum) > sweep.lowest() && maximum > zmap.floor())
                tiles.push_back(index);
        }
    }
}

} // namespace proveout
