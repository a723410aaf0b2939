// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts one motion into the z-map: finds the tiles that it may lower, then lowers each of them.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/lower_tile.h"
#include "core/cutting/cut/sweep.h"
#include "core/cutting/cut/tiles_under.h"

namespace proveout {

namespace {

/// With fewer points than this under the reach, waking other threads costs more than they save.
constexpr double kPointsWorthThreads = 100'000;
/// Work that takes longer than about 20 ms checks whether it should stop. In points of a straight motion.
constexpr double kPointsWorthStopping = 1'000'000;

double pointsUnder(const Sweep& sweep, const Grid& grid, std::size_t tiles) {
    const Box3& reach = sweep.reach();
    return std::min(static_cast<double>(tiles) * Tile::kSize * Tile::kSize,
                    (reach.hi.x - reach.lo.x) / grid.hx * ((reach.hi.y - reach.lo.y) / grid.hy));
}

/// The work on one tile and its result.
struct DoneTile {
    TileCut cut;
    CutRecord record;
};

DoneTile lowerBy(const PreparedSweep& prepared, ZMap& zmap, std::size_t tile, const std::stop_token& stop) {
    constexpr std::uint32_t kFirst = 0;
    DoneTile done;
    done.cut = lowerTile(zmap, tile, {&prepared, 1}, {&kFirst, 1}, {&done.record, 1}, stop);
    return done;
}

void adopt(ZMap& zmap, std::size_t index, DoneTile& done, CutRecord& record) {
    if (done.cut.copy)
        zmap.adoptTile(index, std::move(done.cut.copy));
    record.add(done.record);
}

/// The record is summed in the order of the tiles, whichever thread lowered them.
CutRecord collect(ZMap& zmap, const std::vector<std::size_t>& tiles, std::vector<DoneTile>& done) {
    CutRecord record;
    for (std::size_t k = 0; k < tiles.size(); ++k)
        adopt(zmap, tiles[k], done[k], record);
    return record;
}

std::vector<DoneTile> lowerAtOnce(ZMap& zmap, const std::vector<std::size_t>& tiles,
                                  const PreparedSweep& prepared, const std::stop_token& stop) {
    std::vector<DoneTile> done(tiles.size());
    inParallel(tiles.size(), [&](std::size_t k) { done[k] = lowerBy(prepared, zmap, tiles[k], stop); });
    return done;
}

CutRecord lower(ZMap& zmap, const std::vector<std::size_t>& tiles, const PreparedSweep& prepared,
                bool withThreads) {
    if (withThreads && tiles.size() > 1) {
        std::vector<DoneTile> done = lowerAtOnce(zmap, tiles, prepared, {});
        return collect(zmap, tiles, done);
    }
    CutRecord record;
    for (const std::size_t index : tiles) {
        DoneTile done = lowerBy(prepared, zmap, index, {});
        adopt(zmap, index, done, record);
    }
    return record;
}

/// All tiles are lowered as copies, so that the map stays unchanged if not all of them get done.
std::optional<CutRecord> lowerUnlessStopped(ZMap& zmap, const std::vector<std::size_t>& tiles,
                                            const PreparedSweep& prepared, const std::stop_token& stop) {
    (void)zmap.snapshot(); // from now on every tile counts as shared
    std::vector<DoneTile> done = lowerAtOnce(zmap, tiles, prepared, stop);
    if (!std::ranges::all_of(done, [](const DoneTile& tile) { return tile.cut.complete; }))
        return std::nullopt;
    return collect(zmap, tiles, done);
}

} // namespace

void CutRecord::add(const CutRecord& other) {
    removedMm3 += other.removedMm3;
    maxDepth = std::max(maxDepth, other.maxDepth);
    points += other.points;
    changed = hull(changed, other.changed);
    engagedFrom = std::min(engagedFrom, other.engagedFrom);
    engagedTo = std::max(engagedTo, other.engagedTo);
}

CutRecord cut(ZMap& zmap, const Cutter& cutter, const Motion& motion) {
    return *cut(zmap, cutter, motion, {}); // without a stop request the cut always completes
}

std::optional<CutRecord> cut(ZMap& zmap, const Cutter& cutter, const Motion& motion,
                             const std::stop_token& stop) {
    return cut(zmap, CutterMotion{&cutter, motion}, stop);
}

bool continues(const CutterMotion& before, const CutterMotion& motion) {
    return before.cutter == motion.cutter && before.motion.known() && withinLimits(before.motion) &&
           before.motion.end == motion.motion.start;
}

std::optional<CutRecord> cut(ZMap& zmap, const CutterMotion& one, const std::stop_token& stop) {
    if (one.cutter == nullptr)
        return CutRecord();
    const PreparedSweep prepared(*one.cutter, one.motion, zmap, one.continues);
    const Sweep& sweep = prepared.sweep;
    if (sweep.empty() || zmap.tileCount() == 0)
        return CutRecord();
    std::vector<std::size_t> tiles;
    tilesToLower(zmap, sweep, tiles);
    const double points = pointsUnder(sweep, zmap.grid(), tiles.size());
    std::optional<CutRecord> record =
        stop.stop_possible() && points * prepared.costOfPoint() > kPointsWorthStopping
            ? lowerUnlessStopped(zmap, tiles, prepared, stop)
            : lower(zmap, tiles, prepared, points > kPointsWorthThreads);
    if (record)
        record->removedMm3 *= zmap.grid().hx * zmap.grid().hy;
    return record;
}

} // namespace proveout
