// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/compensated_path.h"
#include "core/nc/motions/corner_insertion.h"
#include "core/nc/motions/known_axes.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/run/block_plan.h"
#include "core/nc/run/lint.h"
#include "core/nc/run/skipped_block.h"
#include "core/nc/state/execution.h"
#include "core/nc/state/probing.h"

namespace proveout {

namespace {

/// Stores what macros can read about the last block.
void remember(Execution& execution) {
    for (const Word& word : execution.block.codes()) {
        if (word.letter == 'M')
            execution.state.lastM = word.value;
    }
    if (execution.block.has('B'))
        execution.state.lastB = execution.block.value('B');
}

/// LinuxCNC reads from the machine where a tool change has left the tip only after the block.
void readBackAfterToolChange(Execution& execution) {
    constexpr double kToolChange = 6;
    if (!execution.dialect.readsBackAtToolChange)
        return;
    for (const Word& word : execution.block.codes()) {
        if (word.letter == 'M' && word.value == kToolChange && !execution.state.compensation.on)
            continueFromTip(execution);
    }
}

} // namespace

void executeBlock(Execution& execution) {
    const MachineState before = execution.state;
    execution.motionBefore = before.motion;
    BlockPlan plan;
    if (!makePlan(execution, plan)) {
        execution.state = before;
        forgetAxes(execution.state, execution.block.letters(), Forgotten::reported);
        if (!execution.dialect.streamed)
            keepModes(execution, true);
        return;
    }
    execution.program.beginBlock(execution.line);
    const std::size_t first = execution.program.motionCount();
    plan.run(execution);
    readBackAfterToolChange(execution);
    if (execution.dialect.vectors.used) {
        countBlock(execution);
        checkOrderedCorner(execution);
    }
    if (execution.dialect.macros == MacroLanguage::macroB)
        remember(execution);
    lookForProbeUse(execution, before.probed.axes, first);
    if (execution.lint == nullptr)
        return;
    lintBlock({execution, before, *execution.lint, first});
    if (execution.state.ended)
        lintEnd({execution, before, *execution.lint, first});
}

} // namespace proveout
