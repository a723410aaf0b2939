// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <utility>

#include "core/nc/codes/ignored_codes.h"
#include "core/nc/flow/unreachable.h"
#include "core/nc/run/line_reader.h"
#include "core/nc/run/repeat_guard.h"
#include "core/nc/state/control_memory.h"

namespace proveout {

/// What an interpretation carries from line to line, in addition to its open calls. A value.
struct RunState {
    RunState(MacroLanguage language, ToolOffsets known) : memory(language, std::move(known)) {}

    ControlMemory memory;
    ReadState read;
    RepeatState repeats;
    std::size_t steps = 0; ///< lines that were run

    // What is reported at the end, or once.
    Unreachable unreachable;
    IgnoredCodes ignored;
    std::set<int> assumedVariables; ///< that were reported
};

} // namespace proveout
