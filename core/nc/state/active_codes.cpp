// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/state/active_codes.h"

#include <array>
#include <cstddef>

#include "core/nc/codes/modal_groups.h"
#include "core/nc/state/machine_state.h"

namespace proveout {

int activeCode(const MachineState& state, ModalGroup group, const Dialect& dialect) {
    const CodeOfState inForce = rowOf(group).inForce;
    return inForce == nullptr ? -1 : inForce(state, dialect);
}

double restoringCode(const MachineState& state, ModalGroup group, const Dialect& dialect) {
    const ModalGroupRow& row = rowOf(group);
    return (row.restores == nullptr ? row.inForce : row.restores)(state, dialect) / 10.0;
}

int motionInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.motion == nullptr ? 800 : state.motion->tenths;
}

int planeInForce(const MachineState& state, const Dialect& /*dialect*/) {
    constexpr std::array kCodes{170, 180, 190};
    return kCodes[static_cast<std::size_t>(state.plane)];
}

int distanceInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.incremental ? 910 : 900;
}

int arcDistanceInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.arcCentreAbsolute ? 901 : 911;
}

int feedModeInForce(const MachineState& state, const Dialect& /*dialect*/) {
    constexpr std::array kCodes{940, 930, 950};
    return kCodes[static_cast<std::size_t>(state.feedMode)];
}

int unitsInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.inch ? 200 : 210;
}

int compensationInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return !state.compensation.on ? 400 : state.compensation.side >= 0 ? 410 : 420;
}

int toolLengthInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.lengthSign == 0 ? 490 : state.lengthSign > 0 ? 430 : 440;
}

/// LinuxCNC treats a zero offset as none, and restores any other as that of the tool in the spindle.
int toolLengthRestored(const MachineState& state, const Dialect& /*dialect*/) {
    return state.toolOffset == Vec3(0) ? 490 : 430;
}

int retractInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.retractToR ? 990 : 980;
}

int workOffsetInForce(const MachineState& state, const Dialect& dialect) {
    constexpr int kStandard = 6; // G54 to G59
    const int further = state.workOffset - kStandard;
    if (further <= 0)
        return 530 + 10 * state.workOffset;
    return dialect.additionalCode.tenths + dialect.additionalCode.step * further;
}

int spindleModeInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.surfaceSpeed ? 960 : 970;
}

int polarInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.polar.on ? 160 : 150;
}

int mirroringInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.frame.transformation.mirrored != 0 ? 511 : 501;
}

int scalingInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.frame.transformation.scaled ? 510 : 500;
}

int rotationInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.frame.transformation.turned ? 680 : 690;
}

int macroCallInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.modalMacro ? 660 : 670;
}

int shiftInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.shifted ? 923 : 922;
}

int spindleInForce(const MachineState& state, const Dialect& /*dialect*/) {
    return state.spindleDirection == 0 ? 50 : state.spindleDirection > 0 ? 30 : 40;
}

} // namespace proveout
