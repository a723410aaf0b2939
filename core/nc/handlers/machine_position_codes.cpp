// SPDX-License-Identifier: GPL-3.0-or-later
// Motions in machine coordinates of Fanuc's dialect: G28, G30, G53. Source: FANUC's operator's manuals,
// reference position, machine coordinate system.
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/cycles/cycle_order.h"
#include "core/nc/motions/compensated_path.h"
#include "core/nc/motions/known_axes.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr int kZ = 2;

bool isStationary(const Motion& motion) {
    return motion.start == motion.end && motion.startKnown == motion.endKnown;
}

/// An increment of 0, as in G91 G28 Z0, does not move the axis, wherever it is.
bool goesNowhere(const Execution& execution) {
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)) && execution.block.value(letterOfAxis(axis)) != 0)
            return false;
    }
    return execution.state.incremental;
}

void goByWayOf(Execution& execution) {
    if (goesNowhere(execution))
        return;
    const Motion motion = motionToTarget(execution, MotionKind::rapid);
    if (!isStationary(motion))
        appendMotion(execution, motion);
}

/// Cutter compensation ends for the motion to the reference position and starts again after it.
void suspendCompensation(Execution& execution, const Word& word) {
    CutterCompensation& compensation = execution.state.compensation;
    if (!compensation.on)
        return;
    const PlaneAxes plane = axes(execution.state.plane);
    // The manuals do not say what happens to the offset in axes that do not move.
    if (!execution.block.has(letterOfAxis(plane.first)) || !execution.block.has(letterOfAxis(plane.second)))
        execution.reporter.report(nc_message::kCompensationSuspended, word, {nameOf(word)});
    finishCompensated(execution, word);
    compensation.entered = compensation.held = false;
}

/// Machine coordinates refer to the spindle, the program's motions to the tip.
void sendTo(Execution& execution, Motion& motion, int axis, double value) {
    setMachineTarget(execution, motion, axis, value - execution.state.toolOffset[axis]);
    if (axis == kZ && !execution.state.machineZeroKnown)
        motion.endAtReference = value == 0;
}

/// Moves by way of the point of the axis words to the first reference position, which is machine zero; the
/// position of any other one is unknown.
void goToReference(Execution& execution, const Word& word, bool first) {
    reportReferenceInCycle(execution, word);
    const bool named = execution.block.letters().any(kAxisWords);
    if (!named && !execution.dialect.allAxesGoHome) {
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "X"});
        return;
    }
    suspendCompensation(execution, word);
    goByWayOf(execution);
    MachineState& state = execution.state;
    const Vec3 intermediate = state.frame.toProgram(state.position);
    Motion home = motionFromHere(execution, MotionKind::rapid);
    for (int axis = 0; axis < 3; ++axis) {
        if (named && !execution.block.has(letterOfAxis(axis)))
            continue;
        const auto bit = axisBit(axis);
        state.intermediate[axis] = intermediate[axis];
        state.intermediateKnown |= static_cast<std::uint8_t>(state.known & bit);
        if (first) {
            sendTo(execution, home, axis, 0);
            continue;
        }
        home.endKnown &= static_cast<std::uint8_t>(~bit);
        home.endAtReference = home.endAtReference || axis == kZ;
    }
    appendMotion(execution, home);
}

} // namespace

void goToMachineZero(Execution& execution, const Word& word) {
    goToReference(execution, word, true);
}

void goToFurtherReference(Execution& execution, const Word& word) {
    constexpr int kSecond = 2;
    constexpr int kFourth = 4;
    if (!execution.block.has('P') || wholeNumber(execution, execution.block.word('P'), kSecond, kFourth))
        goToReference(execution, word, false);
    else
        forgetAxes(execution.state, execution.block.letters(), Forgotten::reported);
}

void moveInMachine(Execution& execution, const Word& word) {
    if (execution.state.incremental) {
        execution.reporter.report(nc_message::kMachineIgnored, word);
        return;
    }
    suspendCompensation(execution, word);
    Motion motion = motionFromHere(execution, MotionKind::rapid);
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)))
            sendTo(execution, motion, axis, execution.length(letterOfAxis(axis)));
    }
    if (execution.block.letters().any(kAxisWords))
        appendMotion(execution, motion);
}

} // namespace proveout
