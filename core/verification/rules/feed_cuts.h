// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks that cut at feed with tools of which something is stated.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/simulation/run/block_set.h"
#include "core/verification/rules/checked_run.h"

namespace proveout {

/// A block that moves at feed. References to what the run has.
struct FeedBlock {
    std::size_t block = 0;
    int tool = 0;
    const Cutter& cutter;
    double lowest = std::numeric_limits<double>::infinity(); ///< z of the tip, rapids included
    // Of its motions at feed:
    double feed = 0;       ///< the largest, mm/min
    double rpm = 0;        ///< the largest, without sign
    double length = 0;     ///< mm
    double minutes = 0;    ///< at the programmed feed; 0 if a motion has none
    double steepest = 0;   ///< the largest angle below level, degrees
    bool sideways = false; ///< whether one of them moves in X or Y

    [[nodiscard]] const CuttingData& data() const { return cutter.data(); }
};

/// One that cuts, with its record.
struct FeedCut : FeedBlock {
    const BlockStatistics& of;
};

/// What moves less in X and Y, mm, moves along its axis: a control rounds the end of a compensated or rotated
/// motion.
inline constexpr double kSideways = 0.01;

/// Whether a motion moves in X or Y.
[[nodiscard]] inline bool movesInPlan(const Motion& motion) {
    const Box3 box = bounds(motion);
    return std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y) > kSideways;
}

/// The average angle of a motion below level, degrees; not positive if it does not go down.
[[nodiscard]] double angleDown(const Motion& motion);

/// Whether a cutter is a tap; null is not.
[[nodiscard]] bool isTap(const Cutter* cutter);

/// Adds a motion of the block.
void addMotion(FeedBlock& block, const Motion& motion);

/// Calls `visit` with each of the blocks that `isOne`, moves at feed, and has a tool whose data `concerns`,
/// in order. Costs next to nothing if the table has no such tool.
template<class IsOne, class Concerns, class Visit>
void forEachFeedBlock(const CheckedRun& run, const IsOne& isOne, const Concerns& concerns,
                      const Visit& visit) {
    const auto isConcerned = [&](const auto& tool) { return concerns(tool.second.data()); };
    if (std::ranges::none_of(run.setup.tools.tools(), isConcerned))
        return;
    for (std::size_t index = 0; index < run.program.blockCount(); ++index) {
        if (!isOne(index))
            continue;
        const Cutter* cutter = run.cutterOf(index);
        if (cutter == nullptr || !concerns(cutter->data()))
            continue;
        FeedBlock block{.block = index, .tool = run.toolOf(index), .cutter = *cutter};
        const auto motions = run.program.blockMotions(index);
        for (std::size_t motion = motions.first; motion < motions.last; ++motion)
            addMotion(block, run.program.motion(motion));
        if (block.length > 0)
            visit(block);
    }
}

/// Adds those without a record that move at feed, have a tool whose data `concerns`, and `mayBreak` a rule.
template<class Concerns, class MayBreak>
void needFeedBlocks(const CheckedRun& run, BlockSet& out, const Concerns& concerns,
                    const MayBreak& mayBreak) {
    const auto isUnknown = [&](std::size_t block) { return !run.isRecorded(block); };
    forEachFeedBlock(run, isUnknown, concerns, [&](const FeedBlock& block) {
        if (mayBreak(block))
            out.add(block.block);
    });
}

/// The same as forEachFeedBlock() with those that cut.
template<class Concerns, class Visit>
void forEachFeedCut(const CheckedRun& run, const Concerns& concerns, const Visit& visit) {
    const auto cuts = [&](std::size_t block) { return run.rows[block].cuts(); };
    forEachFeedBlock(run, cuts, concerns, [&](const FeedBlock& block) {
        visit(FeedCut{block, run.rows[block.block]});
    });
}

} // namespace proveout
