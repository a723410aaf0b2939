// SPDX-License-Identifier: GPL-3.0-or-later
// Positioning codes of Fanuc that are not motion codes: G27, G29, G60.
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/cycles/cycle_order.h"
#include "core/nc/motions/known_axes.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

/// Moves to the point at which the axes of the block turned towards their reference position; false if there
/// is none.
bool moveToIntermediate(Execution& execution, const Word& word) {
    MachineState& state = execution.state;
    Motion motion = motionFromHere(execution, MotionKind::rapid);
    Vec3 program = state.frame.toProgram(state.position);
    std::uint8_t named = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (!execution.block.has(static_cast<char>('X' + axis)))
            continue;
        named |= axisBit(axis);
        program[axis] = state.intermediate[axis];
    }
    const auto missing = static_cast<std::uint8_t>(named & ~state.intermediateKnown);
    if (missing != 0) {
        execution.reporter.report(nc_message::kNoIntermediate, word, {namesOfAxes(missing)});
        forgetAxes(state, execution.block.letters(), Forgotten::reported);
        return false;
    }
    motion.end = state.frame.toMachine(program);
    motion.endKnown |= named;
    motion.endAtReference = motion.endAtReference && (named & kAxisZ) == 0;
    appendMotion(execution, motion);
    return true;
}

} // namespace

void checkReference(Execution& execution, const Word& word) {
    reportReferenceInCycle(execution, word);
    appendMotion(execution, motionToTarget(execution, MotionKind::rapid));
}

void returnFromReference(Execution& execution, const Word& word) {
    reportReferenceInCycle(execution, word);
    if (moveToIntermediate(execution, word))
        appendMotion(execution, motionToTarget(execution, MotionKind::rapid));
}

void approachFromOneSide(Execution& execution, const Word& word) {
    execution.reporter.report(nc_message::kOneSided, word);
    appendMotion(execution, motionToTarget(execution, MotionKind::rapid));
}

} // namespace proveout
