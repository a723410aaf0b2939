// SPDX-License-Identifier: GPL-3.0-or-later
// Tool length offset by registers: G43, G44, G49 of Fanuc's dialect. Source: FANUC's operator's manuals, tool
// length compensation A.
#include <fmt/format.h>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/handlers/offset_setting.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr int kZ = 2;

/// Activates the length in the register, with `sign`.
void offsetByRegister(Execution& execution, const Word& word, int sign) {
    MachineState& state = execution.state;
    if (execution.block.has('H')) {
        const auto number = wholeNumber(execution, execution.block.word('H'), 0, OffsetRegisters::kLargest);
        if (!number)
            return;
        state.lengthRegister = *number;
    }
    const auto length = execution.registers.length(state.lengthRegister);
    if (!length) {
        if (execution.toolLacks(state.lengthRegister))
            return;
        execution.reporter.report(nc_message::kRegisterUnknown,
                                  execution.block.has('H') ? execution.block.word('H') : word,
                                  {fmt::format("H{}", state.lengthRegister)});
        return;
    }
    state.lengthSign = sign;
    const double offset = sign * *length;
    if (offset != state.toolOffset[kZ] && !execution.block.has('Z'))
        execution.reporter.report(nc_message::kLengthWithoutAxis, word, {nameOf(word)});
    setToolOffset(execution, Vec3(0, 0, offset));
}

} // namespace

void useRegisterLength(Execution& execution, const Word& word) {
    offsetByRegister(execution, word, 1);
}

void subtractRegisterLength(Execution& execution, const Word& word) {
    offsetByRegister(execution, word, -1);
}

void changeRegister(Execution& execution, const Word& word) {
    offsetByRegister(execution, word, execution.state.lengthSign);
}

void endRegisterLength(Execution& execution, const Word& /*word*/) {
    execution.state.lengthSign = 0;
    setToolOffset(execution, Vec3(0));
}

} // namespace proveout
