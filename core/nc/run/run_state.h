// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include <cstddef>
#include <utility>

#include "core/nc/codes/ignored_codes.h"
#include "core/nc/flow/unreachable.h"
#include "core/nc/run/repetition.h"
#include "core/nc/run/serial_line.h"
#include "core/nc/state/lint_memory.h"
#include "core/nc/state/machine_state.h"
#include "core/nc/state/modal_saves.h"
#include "core/nc/state/spline_state.h"
#include "core/nc/state/tool_offsets.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// What an interpretation carries from line to line, beside the calls that it is in. A value.
struct RunState {
    RunState(MacroLanguage language, ToolOffsets known) : parameters(language), tools(std::move(known)) {}

    MachineState machine;
    Parameters parameters;
    ToolOffsets tools;
    ModalSaves saves;
    SplineState splines;
    LintMemory lint;
    SerialLine::Told serial;
    Unreachable unreachable;
    IgnoredCodes ignored;
    std::set<int> assumedVariables; ///< that were reported

    std::size_t linesRead = 0; ///< of the main text, counted to the last one that was reached
    std::size_t linesSeen = 0; ///< of it, counted to the last one on which anything so far depends
    std::size_t steps = 0;
    Repetition repetition;
    std::size_t toldAgain = 0; ///< lines that were told about though they had run before
    std::size_t sourceBlocks = 0;
    bool runsAgain = false; ///< a line was reached that stands before one reached earlier
    double mainNumber = 0;  ///< O of the main program
    bool percentOpen = false;
    bool percentClosed = false;
    bool controlCodeTold = false;
    bool longNumberTold = false;
};

} // namespace proveout
