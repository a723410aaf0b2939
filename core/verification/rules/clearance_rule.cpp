// SPDX-License-Identifier: GPL-3.0-or-later
// The clearance of rapids above the stock of their moment. The program is cut once more for it, for its
// heights alone, and only if a clearance is wanted.
#include <algorithm>
#include <cstddef>

#include "core/cutting/cut/cutting.h"
#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/rules.h"
#include "core/verification/rules/stock_of_moment.h"

namespace proveout {

namespace {

/// A rapid straight up leaves a cut: it begins at the stock.
bool isStraightUp(const Motion& motion) {
    return motion.start.x == motion.end.x && motion.start.y == motion.end.y && motion.end.z >= motion.start.z;
}

/// What the rapid would cut if it were lower by the clearance; 0 if it cuts anyway, which is a fault of its
/// own.
double within(const ZMap& map, const Cutter& cutter, Motion motion, double clearance) {
    motion.start.z -= clearance;
    motion.end.z -= clearance;
    ZMap trial(map.snapshot());
    const double depth = cut(trial, cutter, motion).maxDepth;
    return depth > kNothingRemoved && depth <= clearance + kNothingRemoved ? depth : 0;
}

} // namespace

void judgeClearance(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out) {
    const double clearance = limits.rapidClearance;
    if (clearance == 0 || run.begin == nullptr)
        return;
    StockOfMoment stock(run);
    for (std::size_t block = 0; block < run.program.blockCount(); ++block) {
        const auto motions = run.program.blockMotions(block);
        double closest = 0;
        for (std::size_t index = motions.first; index < motions.last; ++index) {
            const Motion motion = run.program.motion(index);
            if (motion.kind != MotionKind::rapid)
                break; // what follows in a cycle goes into the hole that it makes
            const Cutter* cutter = run.setup.tools.find(run.tools.tool(motion.tool));
            const bool above = bounds(motion).lo.z - clearance >= run.setup.stock.topZ();
            if (cutter != nullptr && motion.known() && !above && !isStraightUp(motion))
                closest = std::max(closest, within(stock.before(block), *cutter, motion, clearance));
        }
        if (closest > 0)
            out.add(rule_finding::kRapidTooClose, block, run.toolOf(block), closest, clearance);
    }
}

} // namespace proveout
