// SPDX-License-Identifier: GPL-3.0-or-later
// Rules about what tools and the spindle may do.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/feed_cuts.h"
#include "core/verification/rules/rules.h"

namespace proveout {

namespace {

bool limitsRamps(const CuttingData& data) {
    return data.steepestRamp < 90;
}

bool anySpindleLimit(const CheckedRun& run) {
    return std::ranges::any_of(run.setup.tools.tools(),
                               [](const auto& tool) { return tool.second.data().mostSpindle > 0; });
}

bool anyTap(const CheckedRun& run) {
    return std::ranges::any_of(run.setup.tools.tools(), [](const auto& tool) { return isTap(&tool.second); });
}

/// Calls `visit` with each motion of a tap, its block, and how deep this block cuts, mm; with null for a
/// block of another tool.
template<class Visit>
void forEachTapMotion(const CheckedRun& run, const Visit& visit) {
    if (!anyTap(run))
        return;
    for (std::size_t block = 0; block < run.rows.size(); ++block) {
        const Cutter* cutter = run.cutterOf(block);
        const auto motions = run.program.blockMotions(block);
        const double depth = run.rows[block].cuts() ? double{run.rows[block].maxDepth} : 0;
        for (std::size_t index = motions.first; index < motions.last; ++index)
            visit(isTap(cutter) ? cutter : nullptr, run.program.motion(index), block, depth);
    }
}

} // namespace

void judgeToolSpindle(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    if (!anySpindleLimit(run))
        return;
    for (std::size_t block = 0; block < run.program.blockCount(); ++block) {
        const Motion last = run.program.motion(run.program.blockMotions(block).last - 1);
        // The speed of the tool before may still be in effect on the way to the first cut.
        if (last.kind == MotionKind::rapid && !run.rows[block].cuts())
            continue;
        const Cutter* cutter = run.cutterOf(block);
        const double most = cutter == nullptr ? 0 : cutter->data().mostSpindle;
        if (most > 0 && std::abs(last.spindleRpm) > most)
            out.add(rule_finding::kToolSpindleLimit, block, run.toolOf(block), std::abs(last.spindleRpm),
                    most);
    }
}

void needForToolSpindle(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    if (!anySpindleLimit(run))
        return;
    for (std::size_t block = 0; block < run.program.blockCount(); ++block) {
        const Motion last = run.program.motion(run.program.blockMotions(block).last - 1);
        if (last.kind == MotionKind::rapid && !run.isRecorded(block))
            out.add(block);
    }
}

void judgeSpindleLimit(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    const double most = run.machine == nullptr ? 0 : run.machine->largestSpindle;
    for (std::size_t block = 0; most > 0 && block < run.program.blockCount(); ++block) {
        const Motion last = run.program.motion(run.program.blockMotions(block).last - 1);
        if (std::abs(last.spindleRpm) > most)
            out.add(rule_finding::kSpindleLimit, block, run.toolOf(block), std::abs(last.spindleRpm), most);
    }
}

void judgeRamps(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    constexpr double kAlike = 0.01; // degrees, as ends are rounded
    forEachFeedCut(run, limitsRamps, [&](const FeedCut& cut) {
        const double most = cut.data().steepestRamp;
        // Going down a wall with some stock left is not a ramp: that takes material under the cutter.
        if (cut.steepest > most + kAlike && double{cut.of.radialEngagement} > cut.cutter.radius())
            out.add(rule_finding::kRampTooSteep, cut.block, cut.tool, cut.steepest, most);
    });
}

void needForRamps(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    needFeedBlocks(run, out, limitsRamps,
                   [](const FeedBlock& block) { return block.steepest > block.data().steepestRamp; });
}

void judgeTapFeed(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out) {
    forEachTapMotion(run, [&](const Cutter* tap, const Motion& motion, std::size_t block, double depth) {
        if (tap == nullptr || depth == 0 || motion.kind == MotionKind::rapid)
            return;
        const double needed = tap->data().pitch * std::abs(motion.spindleRpm);
        const double difference = std::abs(motion.feedMmPerMin - needed);
        if (needed > 0 && difference > needed * limits.tapFeedError / 100)
            out.add(rule_finding::kTapFeed, block, run.toolOf(block), motion.feedMmPerMin, needed);
    });
}

/// For both rules of taps.
void needForTaps(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    if (!anyTap(run))
        return;
    for (std::size_t block = 0; block < run.program.blockCount(); ++block)
        if (!run.isRecorded(block) && isTap(run.cutterOf(block)))
            out.add(block);
}

/// A tap is screwed into the material: it comes out in one piece only if the spindle turns the other way.
void judgeTapOut(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    double deep = 0; // it is in a hole
    double turning = 0;
    forEachTapMotion(run, [&](const Cutter* tap, const Motion& motion, std::size_t block, double depth) {
        const double down = motion.start.z - motion.end.z;
        const bool atFeed = motion.kind != MotionKind::rapid;
        if (tap != nullptr && down > 0 && atFeed && depth > 0) {
            deep = depth;
            turning = motion.spindleRpm;
            return;
        }
        if (tap != nullptr && down >= 0)
            return;
        if (deep > 0 && !(atFeed && motion.spindleRpm * turning < 0))
            out.add(rule_finding::kTapNotReversed, block, run.toolOf(block), deep);
        deep = 0;
    });
}

} // namespace proveout
