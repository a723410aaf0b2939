// SPDX-License-Identifier: GPL-3.0-or-later
// Rules about the load of tools, within the limits that the tool table states.
#include <algorithm>
#include <optional>
#include <vector>

#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/cutting_edge.h"
#include "core/verification/rules/feed_cuts.h"
#include "core/verification/rules/rules.h"

namespace proveout {

namespace {

using Limit = double CuttingData::*;

/// A limit counts as exceeded beyond the difference of two exact cuts; others by a part of themselves,
/// because feeds are stored in single precision.
constexpr double kAlike = 1e-5;

/// Adds the blocks whose value is above a limit of their tool. `valueOf` gives 0 where it does not apply.
template<class ValueOf>
void addAbove(const CheckedRun& run, Limit limit, const FindingRow& row, RuleFindings& out,
              const ValueOf& valueOf, double slack = 0) {
    forEachFeedCut(
        run, [&](const CuttingData& data) { return data.*limit > 0; },
        [&](const FeedCut& cut) {
            const double most = cut.data().*limit;
            const double value = valueOf(cut);
            if (value > most * (1 + kAlike) + slack)
                out.add(row, cut.block, cut.tool, value, most);
        });
}

/// Adds the blocks of tools with a limit that may exceed it.
template<class MayExceed>
void needWhere(const CheckedRun& run, Limit limit, BlockSet& out, const MayExceed& mayExceed) {
    needFeedBlocks(
        run, out, [&](const CuttingData& data) { return data.*limit > 0; },
        [&](const FeedBlock& block) { return mayExceed(block, block.data().*limit); });
}

double spacingOf(const CheckedRun& run) {
    return std::max(run.end.grid().hx, run.end.grid().hy);
}

/// The width of a cut sideways; 0 for a motion along the axis, for which none is measured.
double engagementOf(const FeedCut& cut) {
    return cut.sideways ? double{cut.of.radialEngagement} : 0;
}

bool limitsOtherThanEngagement(const CuttingData& data) {
    return data.limitsCut() && data.mostEngagement == 0;
}

double feedPerTooth(const FeedBlock& block) {
    return block.feed / (block.data().teeth * block.rpm);
}

double chipOf(const FeedCut& cut) {
    if (cut.rpm == 0)
        return 0;
    const double depth = cut.of.maxDepth;
    return cut.sideways ? chipThickness(cut.cutter, feedPerTooth(cut), depth, engagementOf(cut))
                        : chipThicknessDown(cut.cutter, feedPerTooth(cut), depth);
}

/// Blocks that follow each other, of one tool. A block that is shorter than the spacing of the grid removes
/// the material of several or of none, so that only the sum of some has a rate.
class Stretch {
public:
    Stretch(RuleFindings& out, double spacing) : m_out(out), m_spacing(spacing) {}

    void add(const FeedCut& cut) {
        if (!m_blocks.empty() && (cut.tool != m_tool || cut.block != m_blocks.back() + 1))
            end();
        m_tool = cut.tool;
        m_limit = cut.data().mostRemoval;
        m_blocks.push_back(cut.block);
        m_mm3 += cut.of.removedMm3;
        m_minutes += cut.minutes;
        m_length += cut.length;
        if (m_length >= std::max(cut.cutter.radius(), kSpacings * m_spacing))
            end();
    }

    void end() {
        constexpr double kMm3PerCm3 = 1000;
        const double rate = m_minutes > 0 ? m_mm3 / kMm3PerCm3 / m_minutes : 0;
        if (rate > m_limit * (1 + kAlike))
            for (const std::size_t block : m_blocks)
                m_out.add(rule_finding::kRemovalRate, block, m_tool, rate, m_limit);
        m_blocks.clear();
        m_mm3 = m_minutes = m_length = 0;
    }

private:
    static constexpr double kSpacings = 4;

    RuleFindings& m_out;
    double m_spacing;
    int m_tool = 0;
    double m_limit = 0;
    std::vector<std::size_t> m_blocks;
    double m_mm3 = 0;
    double m_minutes = 0;
    double m_length = 0;
};

} // namespace

void judgeDepth(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    addAbove(
        run, &CuttingData::mostDepth, rule_finding::kDepthLimit, out,
        [](const FeedCut& cut) { return cut.sideways ? double{cut.of.maxDepth} : 0; }, kNothingRemoved);
}

void needForDepth(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    const double top = run.setup.stock.topZ();
    needWhere(run, &CuttingData::mostDepth, out, [&](const FeedBlock& block, double most) {
        return block.sideways && top - block.lowest > most;
    });
}

void judgeEngagement(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    addAbove(run, &CuttingData::mostEngagement, rule_finding::kEngagementLimit, out, engagementOf,
             kNothingRemoved);
}

void needForEngagement(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    // The width is measured to within a spacing, and from the ends of the path.
    needWhere(run, &CuttingData::mostEngagement, out,
              [](const FeedBlock& block, double) { return block.sideways; });
}

void judgeChips(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    addAbove(run, &CuttingData::mostChip, rule_finding::kChipLimit, out, chipOf);
}

/// No chip is thicker than the feed per tooth.
void needForChips(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    needWhere(run, &CuttingData::mostChip, out, [](const FeedBlock& block, double most) {
        return block.rpm > 0 && feedPerTooth(block) > most;
    });
}

void judgeSurfaceSpeed(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    addAbove(run, &CuttingData::mostSurfaceSpeed, rule_finding::kSurfaceSpeed, out,
             [](const FeedCut& cut) { return surfaceSpeed(cut.cutter, cut.of.maxDepth, cut.rpm); });
}

void needForSurfaceSpeed(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    constexpr double kAboveProfile = 1e9; // where a cutter is as wide as anywhere
    needWhere(run, &CuttingData::mostSurfaceSpeed, out, [](const FeedBlock& block, double most) {
        return surfaceSpeed(block.cutter, kAboveProfile, block.rpm) > most;
    });
}

void judgeToolFeed(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    addAbove(run, &CuttingData::mostFeed, rule_finding::kToolFeedLimit, out,
             [](const FeedCut& cut) { return cut.feed; });
}

void needForToolFeed(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    needWhere(run, &CuttingData::mostFeed, out,
              [](const FeedBlock& block, double most) { return block.feed > most; });
}

void judgeRemovalRate(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    Stretch stretch(out, spacingOf(run));
    forEachFeedCut(
        run, [](const CuttingData& data) { return data.mostRemoval > 0; },
        [&](const FeedCut& cut) { stretch.add(cut); });
    stretch.end();
}

void needForRemovalRate(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    needWhere(run, &CuttingData::mostRemoval, out, [](const FeedBlock&, double) { return true; });
}

void judgeFullSlots(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    const double spacing = spacingOf(run);
    forEachFeedCut(run, limitsOtherThanEngagement, [&](const FeedCut& cut) {
        const double diameter = 2 * cut.cutter.radius();
        if (diameter > 2 * spacing && engagementOf(cut) > diameter - spacing)
            out.add(rule_finding::kFullSlot, cut.block, cut.tool, engagementOf(cut), diameter);
    });
}

void needForFullSlots(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    needFeedBlocks(run, out, limitsOtherThanEngagement,
                   [](const FeedBlock& block) { return block.sideways; });
}

void judgeEngagementJumps(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    constexpr double kJump = 2;
    std::size_t before = 0; // 1 + the block that was cut last; 0: none
    double width = 0;       // of its cut
    int tool = 0;
    forEachFeedCut(
        run, [](const CuttingData& data) { return data.mostEngagement > 0; },
        [&](const FeedCut& cut) {
            const double now = engagementOf(cut);
            const bool follows = before == cut.block && tool == cut.tool && width > 0;
            if (follows && now > kJump * width && now > cut.data().mostEngagement + kNothingRemoved)
                out.add(rule_finding::kEngagementJump, cut.block, cut.tool, now, cut.data().mostEngagement);
            before = cut.block + 1;
            // In a shorter block the grid does not show the width.
            width = cut.length >= 2 * spacingOf(run) ? now : 0;
            tool = cut.tool;
        });
}

} // namespace proveout
