// SPDX-License-Identifier: GPL-3.0-or-later
// One motion into the z-map: the tiles that it may lower, then each of them.
#include <algorithm>
#include <cmath>
#include <oneapi/tbb/parallel_for.h>
#include <optional>
#include <vector>

#include "core/cutting/cutting.h"
#include "core/cutting/lower_tile.h"
#include "core/cutting/sweep.h"

namespace proveout {

namespace {

/// Below this many points under the reach, waking other threads costs more than they help.
constexpr double kPointsWorthThreads = 100'000;
/// What takes longer than about 20 ms looks whether it shall stop. In points of a straight motion.
constexpr double kPointsWorthStopping = 1'000'000;

/// First and last tile along one axis that [lo, hi] may touch; computed in double, as a motion may reach
/// farther than any index. Nothing when first > last.
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

std::vector<std::size_t> tilesToLower(const ZMap& zmap, const Sweep& sweep) {
    const Grid& grid = zmap.grid();
    std::vector<std::size_t> tiles;
    const Box3& reach = sweep.reach();
    const TileRange rows = tilesUnder(reach.lo.y, reach.hi.y, grid.y0, grid.hy, grid.ny);
    for (int tj = rows.first; tj <= rows.last; ++tj) {
        const double y0 = grid.y(tj * Tile::kSize);
        const Span span = sweep.bandSpan(y0, y0 + (Tile::kSize - 1) * grid.hy);
        const TileRange columns = tilesUnder(span.lo, span.hi, grid.x0, grid.hx, grid.nx);
        for (int ti = columns.first; ti <= columns.last; ++ti) {
            const auto index = static_cast<std::size_t>(tj) * static_cast<std::size_t>(zmap.tilesX()) +
                               static_cast<std::size_t>(ti);
            // A tile that lies below the cutter as a whole cannot change, nor one that is all on the floor.
            const float maximum = zmap.tile(index).maximum;
            if (static_cast<double>(maximum) > sweep.lowest() && maximum > zmap.floor())
                tiles.push_back(index);
        }
    }
    return tiles;
}

double pointsUnder(const Sweep& sweep, const Grid& grid, std::size_t tiles) {
    const Box3& reach = sweep.reach();
    return std::min(static_cast<double>(tiles) * Tile::kSize * Tile::kSize,
                    (reach.hi.x - reach.lo.x) / grid.hx * ((reach.hi.y - reach.lo.y) / grid.hy));
}

void take(ZMap& zmap, std::size_t index, TileCut& done, CutRecord& record) {
    if (done.copy)
        zmap.adoptTile(index, std::move(done.copy));
    record.add(done.record);
}

/// The record is summed in the order of the tiles, whichever thread lowered them.
CutRecord takeAll(ZMap& zmap, const std::vector<std::size_t>& tiles, std::vector<TileCut>& done) {
    CutRecord record;
    for (std::size_t k = 0; k < tiles.size(); ++k)
        take(zmap, tiles[k], done[k], record);
    return record;
}

/// A sweep, and how its inner loops see it.
struct Work {
    const Sweep& sweep;
    std::vector<StraightPass> passes;

    [[nodiscard]] TileCut lower(ZMap& zmap, std::size_t tile, const std::stop_token& stop) const {
        return lowerTile(zmap, tile, sweep, passes, stop);
    }
};

std::vector<TileCut> lowerAtOnce(ZMap& zmap, const std::vector<std::size_t>& tiles, const Work& work,
                                 const std::stop_token& stop) {
    std::vector<TileCut> done(tiles.size());
    tbb::parallel_for(std::size_t{0}, tiles.size(),
                      [&](std::size_t k) { done[k] = work.lower(zmap, tiles[k], stop); });
    return done;
}

CutRecord lower(ZMap& zmap, const std::vector<std::size_t>& tiles, const Work& work, bool withThreads) {
    if (withThreads && tiles.size() > 1) {
        std::vector<TileCut> done = lowerAtOnce(zmap, tiles, work, {});
        return takeAll(zmap, tiles, done);
    }
    CutRecord record;
    for (const std::size_t index : tiles) {
        TileCut done = work.lower(zmap, index, {});
        take(zmap, index, done, record);
    }
    return record;
}

/// All tiles are lowered as copies, so that the map stays as it was where they do not all get done.
std::optional<CutRecord> lowerUnlessStopped(ZMap& zmap, const std::vector<std::size_t>& tiles,
                                            const Work& work, const std::stop_token& stop) {
    (void)zmap.snapshot(); // from now on every tile counts as shared
    std::vector<TileCut> done = lowerAtOnce(zmap, tiles, work, stop);
    if (!std::ranges::all_of(done, &TileCut::complete))
        return std::nullopt;
    return takeAll(zmap, tiles, done);
}

} // namespace

void CutRecord::add(const CutRecord& other) {
    removedMm3 += other.removedMm3;
    maxDepth = std::max(maxDepth, other.maxDepth);
    points += other.points;
    changed = hull(changed, other.changed);
}

CutRecord cut(ZMap& zmap, const Cutter& cutter, const Motion& motion) {
    return *cut(zmap, cutter, motion, {}); // what nobody stops is finished
}

std::optional<CutRecord> cut(ZMap& zmap, const Cutter& cutter, const Motion& motion,
                             const std::stop_token& stop) {
    const Sweep sweep(cutter, motion, zmap.stock().topZ());
    if (sweep.empty() || zmap.tileCount() == 0)
        return CutRecord();
    const std::vector<std::size_t> tiles = tilesToLower(zmap, sweep);
    const double points = pointsUnder(sweep, zmap.grid(), tiles.size());
    const Work work{sweep, sweep.passes(zmap.grid().hx, zmap.grid().hy)};
    std::optional<CutRecord> record =
        stop.stop_possible() && points * sweep.costOfPoint() > kPointsWorthStopping
            ? lowerUnlessStopped(zmap, tiles, work, stop)
            : lower(zmap, tiles, work, points > kPointsWorthThreads);
    if (record)
        record->removedMm3 *= zmap.grid().hx * zmap.grid().hy;
    return record;
}

} // namespace proveout
