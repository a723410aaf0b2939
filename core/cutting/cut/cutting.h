// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting: heights become the minimum of themselves and the lower envelope of the swept cutter.
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

/// What one motion did.
struct CutRecord {
    double removedMm3 = 0;   ///< change of the z-map's volume (border points weigh half, corners a quarter)
    double maxDepth = 0;     ///< largest height removed at a point, mm
    std::int64_t points = 0; ///< points that became lower
    IndexRect changed;       ///< the box of these points
    /// How far beside the path these points lie, mm, left of it positive: from where to where. Of a plunge,
    /// along Y.
    float engagedFrom = std::numeric_limits<float>::infinity();
    float engagedTo = -std::numeric_limits<float>::infinity();

    /// The width that was cut across the path, mm, to one spacing of the grid.
    [[nodiscard]] double radialEngagement() const {
        return points > 0 ? static_cast<double>(engagedTo) - static_cast<double>(engagedFrom) : 0;
    }
    void add(const CutRecord& other);
};

/// Cuts one motion into the z-map, exact to 1 µm off the cutter's rim, points on the rim included, heights
/// clamped at the stock's floor. Arcs and helices in all three planes are cut as such. Motions whose path is
/// not known, not finite or not within the limits of arcs cut nothing; the interpreter lets none of them pass
/// without a message. Called by the thread that owns `zmap`; works on tiles in parallel inside; the heights
/// do not depend on the number of threads nor on the order of motions. The record's volume is summed in the
/// order of tiles and so is reproducible too.
[[nodiscard]] CutRecord cut(ZMap& zmap, const Cutter& cutter, const Motion& motion);
/// The same, unless it is stopped: then nothing, and the map is what it was. Answers a stop within some 30
/// ms. Motions that are much work take memory for copies of the tiles that they lower.
[[nodiscard]] std::optional<CutRecord> cut(ZMap& zmap, const Cutter& cutter, const Motion& motion,
                                           const std::stop_token& stop);

struct CutterMotion {
    const Cutter* cutter = nullptr; ///< kept by the caller; none: the motion cuts nothing
    Motion motion;
    std::uint32_t mark = 1; ///< what a Provenance names it by; not 0
};
/// cut() of each of these motions, one after the other, to the last bit of heights and records, but tile by
/// tile: a tile stays near the processor while all that touches it is done, and many motions are worth
/// threads where one is not. A record each. Nothing where it was stopped, and the map is what it was; not so
/// the provenance, which is made up to date unless it is null.
[[nodiscard]] std::optional<std::vector<CutRecord>> cut(ZMap& zmap, std::span<const CutterMotion> motions,
                                                        const std::stop_token& stop,
                                                        Provenance* provenance = nullptr);

/// The same heights, to the last bit, where nobody wants records: within a tile in whatever order takes
/// least, which is several times as fast. False where it was stopped, and the map is what it was.
[[nodiscard]] bool cutHeights(ZMap& zmap, std::span<const CutterMotion> motions, const std::stop_token& stop);

/// The lower envelope of the swept cutter over (x, y), absolute z; +infinity where the cutter never comes.
/// Source of truth of `cut`, in double; one point at a time.
[[nodiscard]] double envelope(const Cutter& cutter, const Motion& motion, double x, double y);

} // namespace proveout
