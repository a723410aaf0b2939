// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/nc/flow/call_stack.h"
#include "core/nc/program/program.h"
#include "core/nc/program/reporter.h"
#include "core/nc/run/run_state.h"
#include "core/nc/state/offset_registers.h"

namespace proveout {

/// A point between two lines of a main program at which a run can be resumed. A value.
struct ResumePoint {
    RunState run;
    OffsetRegisters::Contents registers;
    CallStack::Place calls;
    Reporter::Memory reported;
    Program::Extent program;
};

} // namespace proveout
