// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the canned cycles G73 to G89 into their motions; also G98 and G99.
#include <algorithm>

#include "core/nc/codes/handlers.h"
#include "core/nc/cycles/cycle_order.h"
#include "core/nc/cycles/cycle_run.h"
#include "core/nc/state/execution.h"

namespace proveout {

bool depthKnown(const Execution& execution) {
    const auto normal = static_cast<unsigned>(axes(execution.state.plane).normal);
    return (execution.state.known >> normal & 1U) != 0;
}

bool spindleTurns(Execution& execution, const Word& word, SpindleNeed need) {
    const int direction = execution.state.spindleDirection;
    const bool turns = need == SpindleNeed::any || (need == SpindleNeed::turning && direction != 0) ||
                       (need == SpindleNeed::clockwise && direction > 0) ||
                       (need == SpindleNeed::counterClockwise && direction < 0);
    if (turns)
        return true;
    const char* const needed = need == SpindleNeed::turning     ? "M3 / M4"
                               : need == SpindleNeed::clockwise ? "M3"
                                                                : "M4";
    execution.reporter.report(nc_message::kCycleSpindle, word, {needed});
    return false;
}

void reportReferenceInCycle(Execution& execution, const Word& word) {
    // A motion code of the same block ends the cycle first, regardless of the order of the steps.
    const bool ends = std::ranges::any_of(execution.block.codes(), [&](const Word& code) {
        const CodeRow* row = execution.codes.find(code);
        return row != nullptr && !isCycle(row) &&
               (row->group == ModalGroup::motion || row->group == ModalGroup::motionOff);
    });
    if (execution.dialect.noReferenceInCycle && isCycle(execution.state.motion) && !ends)
        execution.reporter.report(nc_message::kReferenceInCycle, word, {nameOf(word)});
}

std::optional<CycleOrder> readCycle(Execution& execution, const Word& word, const CannedCycle& cycle) {
    return execution.dialect.cyclesKeepWords ? readFanucCycle(execution, word, cycle)
                                             : readRs274Cycle(execution, word, cycle);
}

void runCycle(Execution& execution, const Word& word) {
    const CannedCycle& cycle = cycleOf(execution.dialect.id, *execution.state.motion);
    const std::optional<CycleOrder> order = readCycle(execution, word, cycle);
    if (order)
        CycleRun(execution, word, cycle, *order).drillBlock();
}

void retractToInitialLevel(Execution& execution, const Word& /*word*/) {
    execution.state.retractToR = false;
}

void retractToRLevel(Execution& execution, const Word& /*word*/) {
    execution.state.retractToR = true;
}

} // namespace proveout
