// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/block_plan.h"
#include "core/nc/execution.h"
#include "core/nc/lint.h"

namespace proveout {

void executeBlock(Execution& execution) {
    const MachineState before = execution.state;
    execution.motionBefore = before.motion;
    BlockPlan plan;
    if (!makePlan(execution, plan)) {
        execution.state = before;
        execution.state.forget(execution.block.letters());
        return;
    }
    execution.program.beginBlock(execution.line);
    const std::size_t first = execution.program.motionCount();
    plan.run(execution);
    if (execution.lint == nullptr)
        return;
    lintBlock({execution, before, *execution.lint, first});
    if (execution.state.ended)
        lintEnd({execution, before, *execution.lint, first});
}

} // namespace proveout
