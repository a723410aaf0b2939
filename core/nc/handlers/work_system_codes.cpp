// SPDX-License-Identifier: GPL-3.0-or-later
// Work coordinates of Fanuc's dialect: G52, G54 to G59, G54.1, G92, G92.1; G110 to G129 and G154 of Haas.
// Source: FANUC's operator's manuals, workpiece coordinate system, local coordinate system; Haas's manuals.
#include <algorithm>
#include <cmath>

#include "core/nc/codes/handlers.h"
#include "core/nc/state/execution.h"
#include "core/nc/state/offset_parameters.h"
#include "core/nc/state/work_systems.h"

namespace proveout {

namespace {

constexpr int kG54 = 540;
constexpr int kG110 = 1100;

void refresh(Execution& execution) {
    refreshFrame(execution.state, execution.parameters, execution.program, execution.line);
}

void select(Execution& execution, int system) {
    if (system == execution.state.workOffset)
        return;
    execution.state.workOffset = system;
    const WorkFrame before = execution.state.frame;
    refresh(execution);
    if (execution.state.frame == before) // its name changes nevertheless
        execution.program.append(WorkOffset{system, before.zero()}, execution.line);
}

/// Whether another code of the block uses P.
bool othersUseP(const Execution& execution, const Word& own) {
    return std::ranges::any_of(execution.block.codes(), [&](const Word& word) {
        const CodeRow* row = execution.codes.find(word);
        return word.column != own.column && row != nullptr && row->letters.has('P');
    });
}

void selectAdditionalByP(Execution& execution) {
    const int most = execution.dialect.additionalSystems;
    if (const auto number = wholeNumber(execution, execution.block.word('P'), 1, most))
        select(execution, kStandardSystems + *number);
}

} // namespace

void selectWorkSystem(Execution& execution, const Word& word) {
    const int tenths = static_cast<int>(std::lround(word.value * 10));
    if (tenths == kG54 && execution.block.has('P') && !othersUseP(execution, word))
        selectAdditionalByP(execution);
    else
        select(execution, (tenths - kG54) / 10 + 1);
}

void selectAdditionalSystem(Execution& execution, const Word& word) {
    if (execution.block.has('P'))
        selectAdditionalByP(execution);
    else
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "P"});
}

void selectNamedSystem(Execution& execution, const Word& word) {
    const int tenths = static_cast<int>(std::lround(word.value * 10));
    select(execution, kStandardSystems + 1 + (tenths - kG110) / 10);
}

void shiftAllSystems(Execution& execution, const Word& /*word*/) {
    const bool stored = execution.dialect.keepsLocalShift;
    Vec3 local = stored ? vectorAt(execution.parameters, kCommonOffset) : execution.state.localShift;
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)))
            local[axis] = execution.length(letterOfAxis(axis));
    }
    if (stored)
        setVectorAt(execution.parameters, kCommonOffset, local);
    else
        execution.state.localShift = local;
    refresh(execution);
}

void presetCoordinates(Execution& execution, const Word& word) {
    MachineState& state = execution.state;
    if (!execution.block.letters().any(kAxisWords)) {
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "X"});
        return;
    }
    Vec3 wanted = state.frame.toProgram(state.position);
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)))
            wanted[axis] = execution.length(letterOfAxis(axis));
    }
    const Vec3 there = state.frame.toMachine(wanted);
    for (int axis = 0; axis < 3; ++axis) {
        if (!execution.block.has(letterOfAxis(axis)))
            continue;
        const auto bit = axisBit(axis);
        if ((state.known & bit) == 0) {
            // The machine position is unknown, so the program defines it here.
            state.position[axis] = there[axis];
            state.known |= bit;
            state.everKnown |= bit;
            state.unknownReported &= static_cast<std::uint8_t>(~bit);
        }
        state.presetShift[axis] += state.localShift[axis] + state.position[axis] - there[axis];
        state.localShift[axis] = 0;
    }
    refresh(execution);
}

void restoreCoordinates(Execution& execution, const Word& /*word*/) {
    MachineState& state = execution.state;
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)))
            state.presetShift[axis] = state.localShift[axis] = 0;
    }
    refresh(execution);
}

} // namespace proveout
