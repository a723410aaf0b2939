// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/nc/call_stack.h"
#include "core/nc/offset_registers.h"
#include "core/nc/program.h"
#include "core/nc/reporter.h"
#include "core/nc/run_state.h"

namespace proveout {

/// A place between two lines of a main program from which a run can be taken up again. A value.
struct ResumePoint {
    RunState run;
    OffsetRegisters::Contents registers;
    CallStack::Place calls;
    Reporter::Memory told;
    Program::Extent program;
};

} // namespace proveout
