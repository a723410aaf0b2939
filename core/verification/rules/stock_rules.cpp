// SPDX-License-Identifier: GPL-3.0-or-later
// Rules about the program and its stock as a whole.
#include <algorithm>
#include <functional>
#include <vector>

#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/pieces.h"
#include "core/verification/rules/rules.h"

namespace proveout {

namespace {

bool isOverStock(const StockBox& stock, const Box3& path, double radius) {
    return path.hi.x > stock.corner.x - radius && path.lo.x < stock.corner.x + stock.width + radius &&
           path.hi.y > stock.corner.y - radius && path.lo.y < stock.corner.y + stock.depth + radius;
}

} // namespace

void judgeRemoval(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out) {
    if (run.program.blockCount() == 0)
        return; // the interpreter has reported that
    bool touches = false;
    for (std::size_t block = 0; block < run.rows.size() && !touches; ++block)
        touches = run.rows[block].cuts();
    if (!touches)
        return out.add(rule_finding::kNothingCut);
    const double percent = 100 * run.removedMm3 / (run.end.volume() + run.removedMm3);
    if (percent < limits.leastRemoved)
        out.add(rule_finding::kHardlyCuts, percent, limits.leastRemoved);
}

/// Something was removed, but none of the known blocks has done it.
void needForRemoval(const CheckedRun& run, const RuleLimits&, BlockSet& out) {
    if (!run.isDone() || run.removedMm3 <= 0)
        return;
    std::size_t known = 0;
    for (std::size_t block = 0; block < run.rows.size(); ++block) {
        if (run.rows[block].cuts())
            return;
        known += run.isRecorded(block) ? 1 : 0;
    }
    for (std::size_t block = 0; known < run.rows.size() && block < run.rows.size(); ++block)
        out.add(block);
}

void judgeUnits(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    constexpr double kLeast = 20; // an inch has 25.4 mm; stock and cuts are seldom of one size
    constexpr double kMost = 32;
    const Box3& cuts = run.program.cuttingBounds();
    const StockBox& stock = run.setup.stock;
    const double x = (cuts.hi.x - cuts.lo.x) / stock.width;
    const double y = (cuts.hi.y - cuts.lo.y) / stock.depth;
    if (!(x > 0) || !(y > 0))
        return;
    const auto about = [&](double one, double other) {
        return std::min(one, other) >= kLeast && std::max(one, other) <= kMost;
    };
    if (about(x, y))
        out.add(rule_finding::kUnitsTooLarge, std::max(x, y));
    else if (about(1 / x, 1 / y))
        out.add(rule_finding::kUnitsTooSmall, std::max(1 / x, 1 / y));
}

void judgeRoomBelow(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out) {
    const double bottom = run.setup.stock.floorZ();
    for (std::size_t block = 0; block < run.program.blockCount(); ++block) {
        const auto motions = run.program.blockMotions(block);
        const Cutter* cutter = run.cutterOf(block);
        double below = 0;
        for (std::size_t index = motions.first; index < motions.last; ++index) {
            const Motion motion = run.program.motion(index);
            const Box3 path = bounds(motion);
            if (motion.known() && cutter != nullptr && isOverStock(run.setup.stock, path, cutter->radius()))
                below = std::max(below, bottom - path.lo.z);
        }
        if (below > limits.belowStock)
            out.add(rule_finding::kTableCollision, block, run.toolOf(block), below, limits.belowStock);
    }
}

void judgeLoosePieces(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out) {
    std::vector<Piece> pieces = piecesOf(run.end);
    std::ranges::sort(pieces, std::greater(), &Piece::volumeMm3);
    for (std::size_t k = 1; k < pieces.size() && pieces[k].volumeMm3 > limits.looseVolume; ++k)
        out.add(rule_finding::kLoosePiece, pieces[k].volumeMm3, limits.looseVolume, pieces[k].place);
}

} // namespace proveout
