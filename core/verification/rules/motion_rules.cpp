// SPDX-License-Identifier: GPL-3.0-or-later
// Rules about the motions of single blocks.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/cutter/shapes.h"
#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/feed_cuts.h"
#include "core/verification/rules/rules.h"

namespace proveout {

namespace {

/// Whether a motion of the block is at feed and has the property.
template<class Property>
bool anyAtFeed(const CheckedRun& run, std::size_t block, const Property& property) {
    const auto motions = run.program.blockMotions(block);
    for (std::size_t index = motions.first; index < motions.last; ++index) {
        const Motion motion = run.program.motion(index);
        if (motion.kind != MotionKind::rapid && !motion.probing && property(motion))
            return true;
    }
    return false;
}

/// Adds the blocks that cut and move at feed with the property; the value is the depth.
template<class Property>
void addCutting(const CheckedRun& run, const FindingRow& row, RuleFindings& out, const Property& property) {
    for (std::size_t block = 0; block < run.rows.size(); ++block) {
        const BlockStatistics& of = run.rows[block];
        if (of.cuts() && anyAtFeed(run, block, property))
            out.add(row, block, run.toolOf(block), of.maxDepth);
    }
}

bool cutsAlongAxisOnly(const Cutter* cutter) {
    constexpr std::array<std::string_view, 4> kShapes{"drill", "centre", "reamer", "tap"};
    const CutterShape* shape = cutter == nullptr ? nullptr : shapeOf(cutter->spec());
    return shape != nullptr && std::ranges::find(kShapes, std::string_view(shape->key)) != kShapes.end();
}

/// Whether the spindle turns on any motion of the program.
bool everTurnsSpindle(const Program& program) {
    for (std::size_t index = 0; index < program.motionCount(); ++index)
        if (program.motion(index).spindleRpm != 0)
            return true;
    return false;
}

bool isSpindleStopped(const Motion& motion) {
    return motion.spindleRpm == 0;
}

} // namespace

void judgeStoppedSpindle(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    if (everTurnsSpindle(run.program))
        addCutting(run, rule_finding::kSpindleStopped, out, isSpindleStopped);
}

/// Without any M3 and S, or with M3 and no S, the operator may have started the spindle by hand.
void judgeUnusedSpindle(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    if (!everTurnsSpindle(run.program))
        addCutting(run, rule_finding::kSpindleNeverTurns, out, isSpindleStopped);
}

void judgeReversedSpindle(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    addCutting(run, rule_finding::kSpindleReversed, out, [&](const Motion& motion) {
        return motion.spindleRpm < 0 && !isTap(run.setup.tools.find(run.tools.tool(motion.tool)));
    });
}

void judgeSidewaysDrill(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    if (std::ranges::none_of(run.setup.tools.tools(),
                             [](const auto& tool) { return cutsAlongAxisOnly(&tool.second); }))
        return;
    // The shape of a tool that is not confirmed may be wrong: an end mill is called a drill in many comments.
    for (const bool unconfirmed : {false, true}) {
        const FindingRow& row =
            unconfirmed ? rule_finding::kDrillSidewaysUnconfirmed : rule_finding::kDrillSideways;
        addCutting(run, row, out, [&](const Motion& motion) {
            const int tool = run.tools.tool(motion.tool);
            const bool isUnconfirmed = run.setup.tools.unconfirmedOrigin(tool) != nullptr;
            return movesInPlan(motion) && isUnconfirmed == unconfirmed &&
                   cutsAlongAxisOnly(run.setup.tools.find(tool));
        });
    }
}

void judgeFeedLimit(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    if (run.machine == nullptr)
        return;
    const double most = run.machine->largestFeed;
    for (std::size_t block = 0; block < run.program.blockCount(); ++block) {
        double feed = 0;
        (void)anyAtFeed(run, block, [&](const Motion& motion) {
            feed = std::max(feed, motion.feedMmPerMin);
            return false;
        });
        if (feed > most)
            out.add(rule_finding::kFeedLimit, block, run.toolOf(block), feed, most);
    }
}

void judgeAirCutting(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out) {
    std::size_t first = 0;
    double seconds = 0;
    const auto endStretch = [&] {
        if (seconds > limits.airSeconds)
            out.add(rule_finding::kAirCutting, first, run.toolOf(first), seconds, limits.airSeconds);
        seconds = 0;
    };
    for (std::size_t block = 0; block < run.rows.size(); ++block) {
        const bool inAir =
            !run.rows[block].cuts() && anyAtFeed(run, block, [](const Motion&) { return true; });
        if (!inAir) {
            endStretch();
            continue;
        }
        if (seconds == 0)
            first = block;
        seconds += run.times.movingSeconds(block);
    }
    endStretch();
}

} // namespace proveout
