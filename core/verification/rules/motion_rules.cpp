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

/// Adds the blocks that addCutting() may add, whatever they cut.
template<class Property>
void needCutting(const CheckedRun& run, BlockSet& out, const Property& property) {
    for (std::size_t block = 0; block < run.program.blockCount(); ++block)
        if (!run.isRecorded(block) && anyAtFeed(run, block, property))
            out.add(block);
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

/// Of a motion: whether the spindle turns the wrong way.
auto isReversedIn(const CheckedRun& run) {
    return [&run](const Motion& motion) {
        return motion.spindleRpm < 0 && !isTap(run.setup.tools.find(run.tools.tool(motion.tool)));
    };
}

/// Of a motion: whether a tool moves sideways that cuts along its axis only.
auto isSidewaysDrillIn(const CheckedRun& run) {
    return [&run](const Motion& motion) {
        return movesInPlan(motion) && cutsAlongAxisOnly(run.setup.tools.find(run.tools.tool(motion.tool)));
    };
}

bool anyDrill(const CheckedRun& run) {
    return std::ranges::any_of(run.setup.tools.tools(),
                               [](const auto& tool) { return cutsAlongAxisOnly(&tool.second); });
}

/// Calls `add(first, last, seconds)` with each longest sequence of blocks [first, last) that are `inAir`, and
/// their time.
template<class InAir, class Add>
void forEachAirStretch(const CheckedRun& run, const InAir& inAir, const Add& add) {
    std::size_t first = 0;
    double seconds = 0;
    for (std::size_t block = 0; block < run.program.blockCount(); ++block) {
        if (!inAir(block)) {
            add(first, block, seconds);
            first = block + 1;
            seconds = 0;
        } else {
            seconds += run.times.movingSeconds(block);
        }
    }
    add(first, run.program.blockCount(), seconds);
}

bool isAtFeed(const CheckedRun& run, std::size_t block) {
    return anyAtFeed(run, block, [](const Motion&) { return true; });
}

/// Adds so many blocks of a stretch that the parts between them do not take as long as the limit.
void addSamples(const CheckedRun& run, std::size_t first, std::size_t last, double limit, BlockSet& out) {
    constexpr double kSamples = 1.1; // per limit: the last block of a part may be long
    double seconds = 0;
    for (std::size_t block = first; block < last; ++block) {
        seconds += run.times.movingSeconds(block);
        if (seconds < limit / kSamples)
            continue;
        out.add(block);
        seconds = 0;
    }
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

void needForStoppedSpindle(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    needCutting(run, out, isSpindleStopped);
}

void judgeReversedSpindle(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    addCutting(run, rule_finding::kSpindleReversed, out, isReversedIn(run));
}

void needForReversedSpindle(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    needCutting(run, out, isReversedIn(run));
}

void judgeSidewaysDrill(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    if (!anyDrill(run))
        return;
    // The shape of a tool that is not confirmed may be wrong: an end mill is called a drill in many comments.
    for (const bool unconfirmed : {false, true}) {
        const FindingRow& row =
            unconfirmed ? rule_finding::kDrillSidewaysUnconfirmed : rule_finding::kDrillSideways;
        addCutting(run, row, out, [&](const Motion& motion) {
            const auto* origin = run.setup.tools.unconfirmedOrigin(run.tools.tool(motion.tool));
            return (origin != nullptr) == unconfirmed && isSidewaysDrillIn(run)(motion);
        });
    }
}

void needForSidewaysDrill(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    if (anyDrill(run))
        needCutting(run, out, isSidewaysDrillIn(run));
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
    const auto inAir = [&](std::size_t block) {
        return run.isRecorded(block) && !run.rows[block].cuts() && isAtFeed(run, block);
    };
    forEachAirStretch(run, inAir, [&](std::size_t first, std::size_t, double seconds) {
        if (seconds > limits.airSeconds)
            out.add(rule_finding::kAirCutting, first, run.toolOf(first), seconds, limits.airSeconds);
    });
}

/// A block that cuts ends a stretch: as long as some of them do, others need not be known.
void needForAirCutting(const CheckedRun& run, const RuleLimits& limits, BlockSet& out) {
    const auto mayBeInAir = [&](std::size_t block) {
        return !(run.isRecorded(block) && run.rows[block].cuts()) && isAtFeed(run, block);
    };
    forEachAirStretch(run, mayBeInAir, [&](std::size_t first, std::size_t last, double seconds) {
        if (seconds <= limits.airSeconds)
            return;
        if (!run.isDone())
            return addSamples(run, first, last, limits.airSeconds, out);
        for (std::size_t block = first; block < last; ++block)
            if (!run.isRecorded(block))
                out.add(block);
    });
}

} // namespace proveout
