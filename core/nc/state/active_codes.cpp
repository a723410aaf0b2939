// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/state/active_codes.h"

#include <array>
#include <cmath>

namespace proveout {

namespace {

int workOffsetCode(const MachineState& state, const Dialect& dialect) {
    constexpr int kStandard = 6; // G54 to G59
    if (state.workOffset <= kStandard)
        return 530 + 10 * state.workOffset;
    if (dialect.macros == MacroLanguage::labels)
        return 590;
    return dialect.macros == MacroLanguage::macroB ? 541 : 590 + state.workOffset - kStandard;
}

} // namespace

int activeCode(const MachineState& state, ModalGroup group, const Dialect& dialect) {
    const Transformation& turned = state.frame.transformation;
    switch (group) {
    case ModalGroup::motion:
        return state.motion == nullptr ? 800 : state.motion->tenths;
    case ModalGroup::plane: {
        constexpr std::array kCodes{170, 180, 190};
        return kCodes[static_cast<std::size_t>(state.plane)];
    }
    case ModalGroup::distance:
        return state.incremental ? 910 : 900;
    case ModalGroup::arcDistance:
        return state.arcCentreAbsolute ? 901 : 911;
    case ModalGroup::feedMode: {
        constexpr std::array kCodes{940, 930, 950};
        return kCodes[static_cast<std::size_t>(state.feedMode)];
    }
    case ModalGroup::units:
        return state.inch ? 200 : 210;
    case ModalGroup::cutterCompensation:
        return !state.compensation.on ? 400 : state.compensation.side >= 0 ? 410 : 420;
    case ModalGroup::toolLength:
        return state.lengthSign == 0 ? 490 : state.lengthSign > 0 ? 430 : 440;
    case ModalGroup::retract:
        return state.retractToR ? 990 : 980;
    case ModalGroup::workOffset:
        return workOffsetCode(state, dialect);
    case ModalGroup::spindleMode:
        return state.surfaceSpeed ? 960 : 970;
    case ModalGroup::polar:
        return state.polar.on ? 160 : 150;
    case ModalGroup::mirroring:
        return turned.mirrored != 0 ? 511 : 501;
    case ModalGroup::scaling:
        return turned.scaled ? 510 : 500;
    case ModalGroup::rotation:
        return turned.turned ? 680 : 690;
    case ModalGroup::macroCall:
        return state.modalMacro ? 660 : 670;
    default:
        return -1;
    }
}

} // namespace proveout
