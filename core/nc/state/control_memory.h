// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/nc/state/lint_memory.h"
#include "core/nc/state/machine_state.h"
#include "core/nc/state/modal_saves.h"
#include "core/nc/state/spline_state.h"
#include "core/nc/state/tool_offsets.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// What the control remembers from one block to the next, and the memory of the lint rules. A value.
struct ControlMemory {
    ControlMemory(MacroLanguage language, ToolOffsets known)
        : parameters(language), tools(std::move(known)) {}

    MachineState machine;
    Parameters parameters;
    ToolOffsets tools;
    ModalSaves saves;
    SplineState splines;
    LintMemory lint;
};

} // namespace proveout
