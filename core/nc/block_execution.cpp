// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/block_plan.h"
#include "core/nc/execution.h"

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
    plan.run(execution);
}

} // namespace proveout
