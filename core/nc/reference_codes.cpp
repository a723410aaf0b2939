// SPDX-License-Identifier: GPL-3.0-or-later
// Reference positions: G28, G30 and where they lie.
#include "core/nc/execution.h"
#include "core/nc/handlers.h"
#include "core/nc/motion_building.h"
#include "core/nc/offset_parameters.h"

namespace proveout {

namespace {

constexpr LetterSet kAxes("XYZ");

/// By way of the point that the block names to the reference position, with the axes that it names; without
/// any, with all.
void goToReference(Execution& execution, int parameter) {
    const bool all = !execution.block.letters().any(kAxes);
    if (!all || execution.dialect.codeAloneMoves)
        appendMotion(execution, motionToTarget(execution, MotionKind::rapid));
    Motion home = motionFromHere(execution, MotionKind::rapid);
    const Vec3 reference = vectorAt(execution.parameters, parameter);
    for (int axis = 0; axis < 3; ++axis) {
        if (!all && !execution.block.has(static_cast<char>('X' + axis)))
            continue;
        setMachineTarget(execution, home, axis, reference[axis]);
        if (axis == 2 && !execution.state.machineZeroKnown)
            home.endAtReference = true;
    }
    appendMotion(execution, home);
}

void storeReference(Execution& execution, int parameter) {
    setVectorAt(execution.parameters, parameter, execution.state.position);
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
