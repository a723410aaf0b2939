// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks that cut at feed with tools of which something is stated.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/verification/rules/checked_run.h"

namespace proveout {

/// A block that cuts at feed. References to what the run has.
struct FeedCut {
    std::size_t block = 0;
    int tool = 0;
    const Cutter& cutter;
    const BlockStatistics& of;
    // Of its motions at feed:
    double feed = 0;       ///< the largest, mm/min
    double rpm = 0;        ///< the largest, without sign
    double length = 0;     ///< mm
    double minutes = 0;    ///< at the programmed feed; 0 if a motion has none
    double steepest = 0;   ///< the largest angle below level, degrees
    bool sideways = false; ///< whether one of them moves in X or Y

    [[nodiscard]] const CuttingData& data() const { return cutter.data(); }
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

/// Adds what a motion at feed does.
void addMotion(FeedCut& cut, const Motion& motion);

/// Calls `visit` with each block that cuts at feed with a tool whose data `concerns`, in order. Costs next to
/// nothing if the table has no such tool.
template<class Concerns, class Visit>
void forEachFeedCut(const CheckedRun& run, const Concerns& concerns, const Visit& visit) {
    const auto isConcerned = [&](const auto& tool) { return concerns(tool.second.data()); };
    if (std::ranges::none_of(run.setup.tools.tools(), isConcerned))
        return;
    for (std::size_t block = 0; block < run.rows.size(); ++block) {
        if (!run.rows[block].cuts())
            continue;
        const Cutter* cutter = run.cutterOf(block);
        if (cutter == nullptr || !concerns(cutter->data()))
            continue;
        FeedCut cut{.block = block, .tool = run.toolOf(block), .cutter = *cutter, .of = run.rows[block]};
        const auto motions = run.program.blockMotions(block);
        for (std::size_t index = motions.first; index < motions.last; ++index)
            addMotion(cut, run.program.motion(index));
        if (cut.length > 0)
            visit(cut);
    }
}

} // namespace proveout
