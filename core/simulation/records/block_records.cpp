// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/records/block_records.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/run/probed_stock.h"

namespace proveout {

namespace {

constexpr double kSecondsPerMinute = 60;

/// The number of straight pieces that stay within kChordError of the motion.
std::size_t piecesOf(const Motion& motion) {
    if (motion.kind != MotionKind::arc)
        return 1;
    const double radius = arcRadius(motion);
    if (radius <= kChordError)
        return 1;
    const double angle = 2 * std::acos(1 - kChordError / radius);
    return static_cast<std::size_t>(std::max(1.0, std::ceil(std::abs(motion.sweep) / angle)));
}

} // namespace

BlockWay wayOf(const Program& program, std::size_t block) {
    BlockWay way;
    const auto motions = program.blockMotions(block);
    for (std::size_t index = motions.first; index < motions.last; ++index) {
        const Motion motion = program.motion(index);
        const double length = motion.known() ? pathLength(motion) : 0;
        if (motion.kind == MotionKind::rapid) {
            way.rapidLength += length;
            continue;
        }
        way.feedLength += length;
        if (motion.feedMmPerMin > 0 && !motion.perRevolution)
            way.feedSeconds += length / motion.feedMmPerMin * kSecondsPerMinute;
        else
            way.feedIsKnown = false;
    }
    return way;
}

std::optional<double> removalRate(const Program& program, std::size_t block, const BlockStatistics& row) {
    const BlockWay way = wayOf(program, block);
    if (!way.feedIsKnown || way.feedSeconds <= 0)
        return std::nullopt;
    return row.removedMm3 / way.feedSeconds * kSecondsPerMinute;
}

double machineRemovalRate(const MachineTimes& times, std::size_t block, const BlockStatistics& row) {
    const double seconds = times.movingSeconds(block);
    return seconds > 0 ? row.removedMm3 / seconds * kSecondsPerMinute : 0;
}

double removalPerLength(const MachineTimes& times, std::size_t block, const BlockStatistics& row) {
    const double length = times.length(block);
    return length > 0 ? row.removedMm3 / length : 0;
}

bool isFirstContact(const PersistentArray<BlockStatistics>& rows, std::size_t block) {
    return rows[block].cuts() && (block == 0 || !rows[block - 1].cuts());
}

RunTotals totalsOf(const Program& program, const PersistentArray<BlockStatistics>& rows, std::size_t blocks) {
    RunTotals totals;
    const auto keep = [](RunTotals::Extreme& extreme, float value, std::size_t block) {
        if (value > extreme.value)
            extreme = {value, block};
    };
    for (std::size_t block = 0; block < blocks; ++block) {
        const BlockStatistics& row = rows[block];
        const BlockWay way = wayOf(program, block);
        totals.rapidLength += way.rapidLength;
        (row.cuts() ? totals.cuttingLength : totals.airLength) += way.feedLength;
        totals.cuttingBlocks += row.cuts() ? 1 : 0;
        totals.airBlocks += !row.cuts() && way.feedLength > 0 ? 1 : 0;
        keep(totals.axialDepth, row.maxDepth, block);
        keep(totals.radialEngagement, row.radialEngagement, block);
        if (!isFirstContact(rows, block))
            continue;
        ++totals.contacts;
        if (!totals.firstContact)
            totals.firstContact = block;
    }
    return totals;
}

std::optional<Vec3> contactPlace(const std::shared_ptr<const Setup>& setup, const Program& program,
                                 std::size_t block, const WorkContext& context) {
    const auto motions = program.blockMotions(block);
    ProbedStock stock(setup);
    for (std::size_t index = motions.first; index < motions.last; ++index) {
        const Motion motion = program.motion(index);
        if (motion.probing || !motion.known() || !withinLimits(motion))
            continue;
        const std::size_t pieces = piecesOf(motion);
        for (std::size_t piece = 0; piece < pieces && !context.stopped(); ++piece) {
            const auto at = [&](std::size_t k) {
                return pointAt(motion, static_cast<double>(k) / static_cast<double>(pieces));
            };
            if (const auto place = stock.firstTouch(program, index, at(piece), at(piece + 1), context))
                return place;
        }
    }
    return std::nullopt;
}

} // namespace proveout
