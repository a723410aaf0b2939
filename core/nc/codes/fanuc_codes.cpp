// SPDX-License-Identifier: GPL-3.0-or-later
// Source: FANUC Series 0i and 30i, operator's manuals for machining centres.
#include "core/nc/codes/code_rows.h"

#include "core/base/text.h"
#include "core/nc/codes/handlers.h"

namespace proveout {

namespace {

// clang-format off
constexpr CodeRow kFanucRows[] = {
    {'G', 10, ModalGroup::motion, PROVEOUT_TEXT("Core", "straight feed"), moveFeed, Step::motion, LetterSet("XYZ[]")},
    {'G', 20, ModalGroup::motion, PROVEOUT_TEXT("Core", "clockwise arc"), moveArcClockwise, Step::motion, LetterSet("XYZIJKR[]")},
    {'G', 30, ModalGroup::motion, PROVEOUT_TEXT("Core", "counter-clockwise arc"), moveArcCounterClockwise, Step::motion, LetterSet("XYZIJKR[]")},
    {'G', 40, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "dwell"), dwellByLetter, Step::dwell, LetterSet("XUP"), AxisUse::takes},
    {'G', 50, ModalGroup::lookAhead, PROVEOUT_TEXT("Core", "high-speed machining"), keepState, Step::lookAhead, LetterSet("PQR")},
    {'G', 51, ModalGroup::lookAhead, PROVEOUT_TEXT("Core", "look-ahead contour control"), keepState, Step::lookAhead, LetterSet("PQR")},
    {'G', 70, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "hypothetical axis interpolation"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 80, ModalGroup::lookAhead, PROVEOUT_TEXT("Core", "look-ahead control"), keepState, Step::lookAhead, LetterSet("PQ")},
    {'G', 90, ModalGroup::exactStop, PROVEOUT_TEXT("Core", "exact stop in one block"), keepState, Step::pathControl},
    {'G', 100, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "set data"), writeData, Step::nonModal, LetterSet("LPXYZRIJKQABCDHN"), AxisUse::takes},
    {'G', 110, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "end of set data"), keepState, Step::nonModal, {}, AxisUse::none},
    {'G', 121, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "polar coordinate interpolation"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 131, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "polar coordinate interpolation off")},
    {'G', 150, ModalGroup::polar, PROVEOUT_TEXT("Core", "polar coordinates off"), endPolar, Step::polar, {}, AxisUse::none},
    {'G', 160, ModalGroup::polar, PROVEOUT_TEXT("Core", "polar coordinates on"), beginPolar, Step::polar, {}, AxisUse::none},
    {'G', 220, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "stored stroke check on"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 230, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "stored stroke check off")},
    {'G', 250, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "spindle speed watch off")},
    {'G', 260, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "spindle speed watch on")},
    {'G', 270, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "check of the reference position"), checkReference, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 280, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "move to reference position"), goToMachineZero, Step::nonModal, LetterSet("XYZ"), AxisUse::takes},
    {'G', 290, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "return from reference position"), returnFromReference, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 300, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "move to second reference position"), goToFurtherReference, Step::nonModal, LetterSet("XYZP"), AxisUse::takes},
    {'G', 310, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "skip motion (probe)"), skipMotion, Step::nonModal, LetterSet("XYZPQ"), AxisUse::takes, WithCompensation::refused},
    {'G', 330, ModalGroup::motion, PROVEOUT_TEXT("Core", "thread cutting"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 370, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "automatic tool length measurement"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 400, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation off"), endCompensationOnTheWay, Step::cutterCompensation, LetterSet("IJK")},
    {'G', 410, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation left"), compensateLeftByRegister, Step::cutterCompensation, LetterSet("D")},
    {'G', 420, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation right"), compensateRightByRegister, Step::cutterCompensation, LetterSet("D")},
    {'G', 430, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "tool length offset"), useRegisterLength, Step::toolLength, LetterSet("H"), AxisUse::none},
    {'G', 440, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "negative tool length offset"), subtractRegisterLength, Step::toolLength, LetterSet("H"), AxisUse::none},
    {'G', 450, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "lengthen the motion by the offset"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 460, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "shorten the motion by the offset"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 470, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "lengthen the motion by twice the offset"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 480, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "shorten the motion by twice the offset"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 490, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "tool length offset off"), endRegisterLength, Step::toolLength, LetterSet("H"), AxisUse::none},
    {'G', 500, ModalGroup::scaling, PROVEOUT_TEXT("Core", "scaling off"), endScaling, Step::scaling, {}, AxisUse::none, WithCompensation::refused},
    {'G', 501, ModalGroup::mirroring, PROVEOUT_TEXT("Core", "mirroring off"), endMirror, Step::mirroring, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 510, ModalGroup::scaling, PROVEOUT_TEXT("Core", "scaling"), scaleCoordinates, Step::scaling, LetterSet("XYZIJKP"), AxisUse::takes, WithCompensation::refused},
    {'G', 511, ModalGroup::mirroring, PROVEOUT_TEXT("Core", "mirroring"), mirrorAxes, Step::mirroring, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 520, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "local coordinate shift"), shiftAllSystems, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 530, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "machine coordinates"), moveInMachine, Step::nonModal, LetterSet("XYZ"), AxisUse::takes},
    {'G', 540, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 1"), selectWorkSystem, Step::workOffset, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'G', 550, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 2"), selectWorkSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 560, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 3"), selectWorkSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 570, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 4"), selectWorkSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 580, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 5"), selectWorkSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 590, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 6"), selectWorkSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 541, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectAdditionalSystem, Step::workOffset, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'G', 600, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "approach from one side"), approachFromOneSide, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 610, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "exact stop"), selectPathControl, Step::pathControl},
    {'G', 620, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "automatic corner override"), selectPathControl, Step::pathControl},
    {'G', 630, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "tapping mode"), selectPathControl, Step::pathControl},
    {'G', 640, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "cutting mode"), selectPathControl, Step::pathControl},
    {'G', 650, ModalGroup::macroCall, PROVEOUT_TEXT("Core", "macro call"), callMacro, Step::macroCall, {}, AxisUse::allWords},
    {'G', 660, ModalGroup::macroCall, PROVEOUT_TEXT("Core", "modal macro call"), callMacroModally, Step::macroCall, {}, AxisUse::allWords},
    {'G', 661, ModalGroup::macroCall, PROVEOUT_TEXT("Core", "macro call by every block"), nullptr, Step::none, {}, AxisUse::allWords},
    {'G', 670, ModalGroup::macroCall, PROVEOUT_TEXT("Core", "modal macro call off"), cancelModalMacro, Step::macroCall},
    {'G', 680, ModalGroup::rotation, PROVEOUT_TEXT("Core", "coordinate rotation"), turnCoordinates, Step::rotation, LetterSet("XYZR"), AxisUse::takes},
    {'G', 682, ModalGroup::rotation, PROVEOUT_TEXT("Core", "tilted working plane"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 690, ModalGroup::rotation, PROVEOUT_TEXT("Core", "coordinate rotation off"), endTurning, Step::rotation, {}, AxisUse::none},
    {'G', 730, ModalGroup::motion, PROVEOUT_TEXT("Core", "chip-breaking drilling cycle"), runCycle, Step::motion, LetterSet("XYZRLQPK"), AxisUse::none, WithCompensation::refused},
    {'G', 740, ModalGroup::motion, PROVEOUT_TEXT("Core", "left-hand tapping cycle"), runCycle, Step::motion, LetterSet("XYZRLQPK"), AxisUse::none, WithCompensation::refused},
    {'G', 760, ModalGroup::motion, PROVEOUT_TEXT("Core", "fine boring cycle"), runCycle, Step::motion, LetterSet("XYZRLQPKIJ"), AxisUse::none, WithCompensation::refused},
    {'G', 810, ModalGroup::motion, PROVEOUT_TEXT("Core", "drilling cycle"), runCycle, Step::motion, LetterSet("XYZRLQPK"), AxisUse::none, WithCompensation::refused},
    {'G', 820, ModalGroup::motion, PROVEOUT_TEXT("Core", "drilling cycle with dwell"), runCycle, Step::motion, LetterSet("XYZRLQPK"), AxisUse::none, WithCompensation::refused},
    {'G', 830, ModalGroup::motion, PROVEOUT_TEXT("Core", "deep-hole drilling cycle"), runCycle, Step::motion, LetterSet("XYZRLQPK"), AxisUse::none, WithCompensation::refused},
    {'G', 840, ModalGroup::motion, PROVEOUT_TEXT("Core", "right-hand tapping cycle"), runCycle, Step::motion, LetterSet("XYZRLQPK"), AxisUse::none, WithCompensation::refused},
    {'G', 850, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, feed out"), runCycle, Step::motion, LetterSet("XYZRLQPK"), AxisUse::none, WithCompensation::refused},
    {'G', 860, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, stop and rapid out"), runCycle, Step::motion, LetterSet("XYZRLQPK"), AxisUse::none, WithCompensation::refused},
    {'G', 870, ModalGroup::motion, PROVEOUT_TEXT("Core", "back boring cycle"), runCycle, Step::motion, LetterSet("XYZRLQPKIJ"), AxisUse::none, WithCompensation::refused},
    {'G', 880, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, stop and manual out"), runCycle, Step::motion, LetterSet("XYZRLQPK"), AxisUse::none, WithCompensation::refused},
    {'G', 890, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle with dwell, feed out"), runCycle, Step::motion, LetterSet("XYZRLQPK"), AxisUse::none, WithCompensation::refused},
    {'G', 920, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "set the work coordinates"), presetCoordinates, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 921, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "preset the work coordinates"), restoreCoordinates, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 960, ModalGroup::spindleMode, PROVEOUT_TEXT("Core", "constant surface speed"), keepSurfaceSpeed, Step::spindleMode, LetterSet("P")},
    {'M', 50, ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle stop"), stopSpindle, Step::spindleStop},
    {'M', 90, ModalGroup::coolant, PROVEOUT_TEXT("Core", "coolant off"), switchCoolantOff, Step::coolantOff},
    {'M', 190, ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle orientation"), stopSpindle, Step::spindleOrientation, LetterSet("RPQS")},
    {'M', 290, ModalGroup::tapping, PROVEOUT_TEXT("Core", "rigid tapping"), orderRigidTapping, Step::tapping},
    {'M', 980, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "subprogram call"), callSubprogram, Step::subprogram, LetterSet("PL")},
    {'M', 990, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "end of subprogram"), returnToBlock, Step::subprogram, LetterSet("P")},
    {'M', 1980, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "call of a program in external memory")},
};
// clang-format on

} // namespace

std::span<const CodeRow> fanucCodes() {
    return kFanucRows;
}

} // namespace proveout
