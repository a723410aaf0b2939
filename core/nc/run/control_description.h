// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nc/program/control_state.h"

namespace proveout {

struct Dialect;
struct MachineState;
class CallStack;
class CodeTable;
class Parameters;

[[nodiscard]] ControlState describe(const MachineState& state, const Parameters& parameters,
                                    const CallStack& calls, const CodeTable& codes, const Dialect& dialect);

} // namespace proveout
