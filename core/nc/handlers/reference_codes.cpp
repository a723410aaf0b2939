// SPDX-License-Identifier: GPL-3.0-or-later
// Reference positions: G28, G30 and where they are set.
#include "core/nc/codes/handlers.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/state/execution.h"
#include "core/nc/state/offset_parameters.h"

namespace proveout {

namespace {

/// The position of the tip after a move of the axes that the block names; a rotation of the work offset
/// rotates these as well.
Vec3 referenceOfAxes(const Execution& execution, const Vec3& reference, bool all) {
    const MachineState& state = execution.state;
    const Vec3 tip = reference - state.toolOffset;
    if (all || state.frame.rotation == 0)
        return tip;
    const Vec3 home = state.frame.toProgram(tip);
    Vec3 program = state.frame.toProgram(state.position);
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(static_cast<char>('X' + axis)))
            program[axis] = home[axis];
    }
    return state.frame.toMachine(program);
}

/// Reference positions belong to the machine and do not depend on the tool in the spindle. Moves by way of
/// the point that the block names to the reference position, with the axes that it names, or with all axes if
/// it names none.
void goToReference(Execution& execution, int parameter) {
    const bool all = !execution.block.letters().any(kAxisWords);
    if (!all || execution.dialect.codeAloneMoves)
        appendMotion(execution, motionToTarget(execution, MotionKind::rapid));
    Motion home = motionFromHere(execution, MotionKind::rapid);
    const Vec3 reference = referenceOfAxes(execution, vectorAt(execution.parameters, parameter), all);
    for (int axis = 0; axis < 3; ++axis) {
        const bool turns = axis < 2 && execution.state.frame.rotation != 0;
        if (!all && !turns && !execution.block.has(static_cast<char>('X' + axis)))
            continue;
        setMachineTarget(execution, home, axis, reference[axis]);
        if (axis == 2 && !execution.state.machineZeroKnown)
            home.endAtReference = true;
    }
    appendMotion(execution, home);
}

void storeReference(Execution& execution, int parameter) {
    setVectorAt(execution.parameters, parameter, execution.state.position + execution.state.toolOffset);
}

} // namespace

void goHome(Execution& execution, const Word& /*word*/) {
    goToReference(execution, kHomeParameter);
}

void goToSecondReference(Execution& execution, const Word& /*word*/) {
    goToReference(execution, kSecondHomeParameter);
}

void storeHome(Execution& execution, const Word& /*word*/) {
    storeReference(execution, kHomeParameter);
}

void storeSecondReference(Execution& execution, const Word& /*word*/) {
    storeReference(execution, kSecondHomeParameter);
}

} // namespace proveout
