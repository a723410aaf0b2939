// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting: each height becomes the minimum of itself and the lower envelope of the swept cutter.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/index_rect.h"
#include "core/cutter/cutter.h"
#include "core/cutting/cut/provenance.h"
#include "core/nc/program/motion.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The result of one motion.
struct CutRecord {
    double removedMm3 = 0;   ///< change of the z-map's volume (border points weigh half, corners a quarter)
    double maxDepth = 0;     ///< largest height removed at a point, mm
    std::int64_t points = 0; ///< points that were lowered
    IndexRect changed;       ///< the box of these points
    /// The range of distances of these points from the path, mm, positive to the left of it. For a plunge,
    /// measured along Y.
    float engagedFrom = std::numeric_limits<float>::infinity();
    float engagedTo = -std::numeric_limits<float>::infinity();

    /// The width that was cut across the path, mm, to within one spacing of the grid.
    [[nodiscard]] double radialEngagement() const {
        return points > 0 ? static_cast<double>(engagedTo) - static_cast<double>(engagedFrom) : 0;
    }
    void add(const CutRecord& other);
};

/// Cuts one motion into the z-map, exact to 1 µm off the cutter's rim, points on the rim included, heights
/// clamped at the stock's floor. Arcs and helices in all three planes are cut as such, not as lines. Motions
/// whose path is unknown, not finite or not within the limits of arcs cut nothing; the interpreter reports
/// each of them. Called by the thread that owns `zmap`; works on tiles in parallel inside; the heights do not
/// depend on the number of threads or on the order of motions. The record's volume is summed in the order of
/// tiles and so is reproducible too.
[[nodiscard]] CutRecord cut(ZMap& zmap, const Cutter& cutter, const Motion& motion);
/// The same, with a stop token: if stopped, the result is nothing and the map is unchanged. Responds to a
/// stop within some 30 ms. Motions with much work need memory for copies of the tiles that they lower.
[[nodiscard]] std::optional<CutRecord> cut(ZMap& zmap, const Cutter& cutter, const Motion& motion,
                                           const std::stop_token& stop);

struct CutterMotion {
    const Cutter* cutter = nullptr; ///< kept by the caller; null: the motion cuts nothing
    Motion motion;
    std::uint32_t mark = 1; ///< identifies the motion in a Provenance; not 0
    bool recorded = true;   ///< false: its record is not needed
    /// It begins where the motion before it ended, with the same cutter, and that one was cut into this map:
    /// points over which it is lowest at its start need not be cut again.
    bool continues = false;
};
/// Whether a motion begins where one before it ended, with the same cutter, so that it `continues` it.
[[nodiscard]] bool continues(const CutterMotion& before, const CutterMotion& motion);
/// cut() for one of these motions.
[[nodiscard]] std::optional<CutRecord> cut(ZMap& zmap, const CutterMotion& motion,
                                           const std::stop_token& stop);
/// Does cut() for each of these motions, one after the other, with the same heights and records to the last
/// bit, but tile by tile: a tile stays in the cache while everything that touches it is cut, and many motions
/// are worth threads where one is not. One record per motion; those of motions that are not `recorded` may be
/// empty, which makes them several times as fast. If stopped, the result is nothing and the map
/// is unchanged, but the provenance is not restored. `provenance` is updated unless it is null.
[[nodiscard]] std::optional<std::vector<CutRecord>> cut(ZMap& zmap, std::span<const CutterMotion> motions,
                                                        const std::stop_token& stop,
                                                        Provenance* provenance = nullptr);

/// The same heights, to the last bit, without records: within a tile the motions are cut in the fastest
/// order, which makes it several times as fast. False if it was stopped; the map is unchanged then.
[[nodiscard]] bool cutHeights(ZMap& zmap, std::span<const CutterMotion> motions, const std::stop_token& stop);

/// The lower envelope of the swept cutter over (x, y), absolute z; +infinity where the cutter never comes.
/// Reference for `cut`, in double; one point at a time.
[[nodiscard]] double envelope(const Cutter& cutter, const Motion& motion, double x, double y);

} // namespace proveout
