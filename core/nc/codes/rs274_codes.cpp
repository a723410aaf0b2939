// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/code_rows.h"

#include "core/base/text.h"
#include "core/nc/codes/handlers.h"

namespace proveout {

namespace {

// clang-format off
constexpr CodeRow kRs274[] = {
    {'G', 20, ModalGroup::motion, PROVEOUT_TEXT("Core", "clockwise arc"), moveArcClockwise, Step::motion, LetterSet("XYZIJKRP")},
    {'G', 30, ModalGroup::motion, PROVEOUT_TEXT("Core", "counter-clockwise arc"), moveArcCounterClockwise, Step::motion, LetterSet("XYZIJKRP")},
    {'G', 40, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "dwell"), dwell, Step::dwell, LetterSet("P")},
    {'G', 50, ModalGroup::motion, PROVEOUT_TEXT("Core", "cubic spline"), followCubic, Step::motion, LetterSet("XYIJPQ"), AxisUse::none, WithCompensation::refused},
    {'G', 51, ModalGroup::motion, PROVEOUT_TEXT("Core", "quadratic spline"), followQuadratic, Step::motion, LetterSet("XYIJ"), AxisUse::none, WithCompensation::refused},
    {'G', 52, ModalGroup::motion, PROVEOUT_TEXT("Core", "NURBS block"), addNurbsPoint, Step::motion, LetterSet("XYPL"), AxisUse::none, WithCompensation::refused},
    {'G', 53, ModalGroup::motion, PROVEOUT_TEXT("Core", "end of NURBS block"), followNurbs, Step::motion, {}, AxisUse::none, WithCompensation::refused},
    {'G', 70, ModalGroup::diameterMode, PROVEOUT_TEXT("Core", "lathe diameter mode"), refuseDiameters, Step::diameterMode},
    {'G', 80, ModalGroup::diameterMode, PROVEOUT_TEXT("Core", "lathe radius mode"), keepState, Step::diameterMode},
    {'G', 100, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "set offsets"), setOffsets, Step::nonModal, LetterSet("LPXYZRIJQABCUVW"), AxisUse::takes},
    {'G', 171, ModalGroup::plane, PROVEOUT_TEXT("Core", "UV plane")},
    {'G', 181, ModalGroup::plane, PROVEOUT_TEXT("Core", "WU plane")},
    {'G', 191, ModalGroup::plane, PROVEOUT_TEXT("Core", "VW plane")},
    {'G', 280, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "move to reference position"), goHome, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 281, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "store reference position"), storeHome, Step::nonModal, {}, AxisUse::none, WithCompensation::refused},
    {'G', 300, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "move to second reference position"), goToSecondReference, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 301, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "store second reference position"), storeSecondReference, Step::nonModal, {}, AxisUse::none, WithCompensation::refused},
    {'G', 330, ModalGroup::motion, PROVEOUT_TEXT("Core", "spindle-synchronised motion"), moveInStep, Step::motion, LetterSet("XYZK_"), AxisUse::none, WithCompensation::refused},
    {'G', 331, ModalGroup::motion, PROVEOUT_TEXT("Core", "rigid tapping"), tapRigidly, Step::motion, LetterSet("XYZKI_"), AxisUse::none, WithCompensation::refused},
    {'G', 382, ModalGroup::motion, PROVEOUT_TEXT("Core", "probe toward the part, error on failure"), probe, Step::motion, LetterSet("XYZ"), AxisUse::none, WithCompensation::refused},
    {'G', 383, ModalGroup::motion, PROVEOUT_TEXT("Core", "probe toward the part"), probe, Step::motion, LetterSet("XYZ"), AxisUse::none, WithCompensation::refused},
    {'G', 384, ModalGroup::motion, PROVEOUT_TEXT("Core", "probe away from the part, error on failure"), probe, Step::motion, LetterSet("XYZ"), AxisUse::none, WithCompensation::refused},
    {'G', 385, ModalGroup::motion, PROVEOUT_TEXT("Core", "probe away from the part"), probe, Step::motion, LetterSet("XYZ"), AxisUse::none, WithCompensation::refused},
    {'G', 400, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation off"), endCompensation, Step::cutterCompensation},
    {'G', 410, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation left"), compensateLeft, Step::cutterCompensation, LetterSet("DL")},
    {'G', 411, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "dynamic cutter compensation left"), compensateLeftByDiameter, Step::cutterCompensation, LetterSet("DR")},
    {'G', 420, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation right"), compensateRight, Step::cutterCompensation, LetterSet("DL")},
    {'G', 421, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "dynamic cutter compensation right"), compensateRightByDiameter, Step::cutterCompensation, LetterSet("DR")},
    {'G', 430, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "tool length offset"), useToolLength, Step::toolLength, LetterSet("H"), AxisUse::none, WithCompensation::refused},
    {'G', 431, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "dynamic tool length offset"), useGivenLength, Step::toolLength, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 432, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "additional tool length offset"), addToolLength, Step::toolLength, LetterSet("HXYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 490, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "tool length offset off"), cancelToolLength, Step::toolLength, {}, AxisUse::none, WithCompensation::refused},
    {'G', 520, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "local coordinate shift"), shiftLocally, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 530, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "machine coordinates"), keepState, Step::nonModal, LetterSet("XYZ"), AxisUse::machine},
    {'G', 591, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 7"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 592, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 8"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 593, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 9"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 610, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "exact path"), keepState, Step::pathControl, {}, AxisUse::none, WithCompensation::refused},
    {'G', 611, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "exact stop"), keepState, Step::pathControl, {}, AxisUse::none, WithCompensation::refused},
    {'G', 700, ModalGroup::motion, PROVEOUT_TEXT("Core", "finishing cycle or bolt circle"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 710, ModalGroup::motion, PROVEOUT_TEXT("Core", "roughing cycle or bolt arc"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 720, ModalGroup::motion, PROVEOUT_TEXT("Core", "facing cycle or bolt line"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 730, ModalGroup::motion, PROVEOUT_TEXT("Core", "chip-breaking drilling cycle"), runCycle, Step::motion, LetterSet("XYZRLQ"), AxisUse::none, WithCompensation::refused},
    {'G', 740, ModalGroup::motion, PROVEOUT_TEXT("Core", "left-hand tapping cycle"), runCycle, Step::motion, LetterSet("XYZRP"), AxisUse::none, WithCompensation::refused},
    {'G', 760, ModalGroup::motion, PROVEOUT_TEXT("Core", "threading or fine boring cycle"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 810, ModalGroup::motion, PROVEOUT_TEXT("Core", "drilling cycle"), runCycle, Step::motion, LetterSet("XYZRL"), AxisUse::none, WithCompensation::refused},
    {'G', 820, ModalGroup::motion, PROVEOUT_TEXT("Core", "drilling cycle with dwell"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 830, ModalGroup::motion, PROVEOUT_TEXT("Core", "deep-hole drilling cycle"), runCycle, Step::motion, LetterSet("XYZRLQ"), AxisUse::none, WithCompensation::refused},
    {'G', 840, ModalGroup::motion, PROVEOUT_TEXT("Core", "right-hand tapping cycle"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 850, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, feed out"), runCycle, Step::motion, LetterSet("XYZRL"), AxisUse::none, WithCompensation::refused},
    {'G', 860, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, stop and rapid out"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 870, ModalGroup::motion, PROVEOUT_TEXT("Core", "back boring cycle"), runCycle, Step::motion, LetterSet("XYZRLIJK"), AxisUse::none, WithCompensation::refused},
    {'G', 880, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, manual out"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 890, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle with dwell"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 901, ModalGroup::arcDistance, PROVEOUT_TEXT("Core", "absolute arc centres"), setArcCentreAbsolute, Step::arcDistance},
    {'G', 911, ModalGroup::arcDistance, PROVEOUT_TEXT("Core", "incremental arc centres"), setArcCentreIncremental, Step::arcDistance},
    {'G', 920, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "coordinate shift"), shiftCoordinates, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 921, ModalGroup::shiftEnd, PROVEOUT_TEXT("Core", "coordinate shift off, cleared"), clearShift, Step::shiftEnd},
    {'G', 922, ModalGroup::shiftEnd, PROVEOUT_TEXT("Core", "coordinate shift off"), suspendShift, Step::shiftEnd},
    {'G', 923, ModalGroup::shiftEnd, PROVEOUT_TEXT("Core", "coordinate shift restored"), restoreShift, Step::shiftEnd},
    {'G', 960, ModalGroup::spindleMode, PROVEOUT_TEXT("Core", "constant surface speed"), keepSurfaceSpeed, Step::spindleMode, LetterSet("D_")},
    {'G', 980, ModalGroup::retract, PROVEOUT_TEXT("Core", "cycles retract to the initial level"), retractToInitialLevel, Step::retract, {}, AxisUse::none, WithCompensation::refused},
    {'G', 990, ModalGroup::retract, PROVEOUT_TEXT("Core", "cycles retract to the R plane"), retractToRLevel, Step::retract, {}, AxisUse::none, WithCompensation::refused},
    {'M', 190, ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle orientation"), stopSpindle, Step::spindleOrientation, LetterSet("RPQ_")},
    {'M', 480, ModalGroup::overrides, PROVEOUT_TEXT("Core", "overrides on"), keepState, Step::overrides, {}, AxisUse::none, WithCompensation::refused},
    {'M', 490, ModalGroup::overrides, PROVEOUT_TEXT("Core", "overrides off"), keepState, Step::overrides, {}, AxisUse::none, WithCompensation::refused},
    {'M', 500, ModalGroup::overrides, PROVEOUT_TEXT("Core", "feed override"), keepState, Step::overrides, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'M', 510, ModalGroup::overrides, PROVEOUT_TEXT("Core", "spindle override"), keepState, Step::overrides, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'M', 520, ModalGroup::overrides, PROVEOUT_TEXT("Core", "adaptive feed"), keepState, Step::overrides, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'M', 530, ModalGroup::overrides, PROVEOUT_TEXT("Core", "feed stop"), keepState, Step::overrides, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'M', 600, ModalGroup::stop, PROVEOUT_TEXT("Core", "pallet change"), changePallet, Step::stop},
    {'M', 610, ModalGroup::toolChange, PROVEOUT_TEXT("Core", "set the tool number"), setToolNumber, Step::toolChange, LetterSet("Q")},
    {'M', 620, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "digital output on, synchronised"), switchDigitalOutput, Step::inputOutput, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'M', 630, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "digital output off, synchronised"), switchDigitalOutput, Step::inputOutput, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'M', 640, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "digital output on"), switchDigitalOutput, Step::inputOutput, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'M', 650, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "digital output off"), switchDigitalOutput, Step::inputOutput, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'M', 660, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "wait for an input"), waitForInput, Step::inputOutput, LetterSet("PELQ"), AxisUse::none, WithCompensation::refused},
    {'M', 670, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "analog output, synchronised"), setAnalogOutput, Step::inputOutput, LetterSet("EQ"), AxisUse::none, WithCompensation::refused},
    {'M', 680, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "analog output"), setAnalogOutput, Step::inputOutput, LetterSet("EQ"), AxisUse::none, WithCompensation::refused},
    {'M', 700, ModalGroup::modalSave, PROVEOUT_TEXT("Core", "save modal state"), saveModes, Step::modalSave},
    {'M', 710, ModalGroup::modalSave, PROVEOUT_TEXT("Core", "discard modal state"), discardModes, Step::modalSave},
    {'M', 720, ModalGroup::modalSave, PROVEOUT_TEXT("Core", "restore modal state"), restoreModes, Step::modalSave},
    {'M', 730, ModalGroup::modalSave, PROVEOUT_TEXT("Core", "save modal state, restored at the end"), saveModesUntilReturn, Step::modalSave},
    {'M', 980, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "subprogram call"), callProgram, Step::subprogram, LetterSet("PL")},
    {'M', 990, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "end of subprogram"), returnFromProgram, Step::subprogram},
};
// clang-format on

} // namespace

std::span<const CodeRow> rs274Codes() {
    return kRs274;
}

} // namespace proveout
