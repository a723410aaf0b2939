// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/turning_notice.h"

#include "core/nc/state/execution.h"

namespace proveout {

void reportTurning(Execution& execution, std::uint8_t named) {
    Turning& turning = execution.state.turning;
    if ((named & turning.axes) == 0)
        return;
    const bool both = (named & turning.axes) == turning.axes;
    // Increments are relative to the position of the tool when a rotation begins, but not when it ends.
    if (turning.ended ? !both || execution.state.incremental : !both && !execution.state.incremental)
        execution.reporter.report(nc_message::kRotationOneAxis, 1, 0, {turning.ended ? "G69" : "G68"});
    turning = {};
}

} // namespace proveout
