// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/code_rows.h"

#include "core/base/text.h"
#include "core/nc/codes/handlers.h"

namespace proveout {

namespace {

// clang-format off
constexpr CodeRow kBasic[] = {
    {'G', 0, ModalGroup::motion, PROVEOUT_TEXT("Core", "rapid motion"), moveRapid, Step::motion, LetterSet("XYZ")},
    {'G', 10, ModalGroup::motion, PROVEOUT_TEXT("Core", "straight feed"), moveFeed, Step::motion, LetterSet("XYZ")},
    {'G', 20, ModalGroup::motion, PROVEOUT_TEXT("Core", "clockwise arc"), moveArcClockwise, Step::motion, LetterSet("XYZIJKR")},
    {'G', 30, ModalGroup::motion, PROVEOUT_TEXT("Core", "counter-clockwise arc"), moveArcCounterClockwise, Step::motion, LetterSet("XYZIJKR")},
    {'G', 170, ModalGroup::plane, PROVEOUT_TEXT("Core", "XY plane"), setPlaneXy, Step::plane},
    {'G', 180, ModalGroup::plane, PROVEOUT_TEXT("Core", "ZX plane"), setPlaneZx, Step::plane},
    {'G', 190, ModalGroup::plane, PROVEOUT_TEXT("Core", "YZ plane"), setPlaneYz, Step::plane},
    {'G', 200, ModalGroup::units, PROVEOUT_TEXT("Core", "inch"), setInch, Step::units},
    {'G', 210, ModalGroup::units, PROVEOUT_TEXT("Core", "millimetre"), setMillimetre, Step::units},
    {'G', 540, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 1"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 550, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 2"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 560, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 3"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 570, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 4"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 580, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 5"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 590, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 6"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 640, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "path blending"), keepState, Step::pathControl, LetterSet("PQ"), AxisUse::none, WithCompensation::refused},
    {'G', 800, ModalGroup::motionOff, PROVEOUT_TEXT("Core", "motion mode off"), keepState, Step::motion},
    {'G', 900, ModalGroup::distance, PROVEOUT_TEXT("Core", "absolute distances"), setAbsolute, Step::distance},
    {'G', 910, ModalGroup::distance, PROVEOUT_TEXT("Core", "incremental distances"), setIncremental, Step::distance},
    {'G', 930, ModalGroup::feedMode, PROVEOUT_TEXT("Core", "inverse time feed"), feedInverseTime, Step::feedMode},
    {'G', 940, ModalGroup::feedMode, PROVEOUT_TEXT("Core", "feed per minute"), feedPerMinute, Step::feedMode},
    {'G', 950, ModalGroup::feedMode, PROVEOUT_TEXT("Core", "feed per revolution"), feedPerRevolution, Step::feedMode},
    {'G', 970, ModalGroup::spindleMode, PROVEOUT_TEXT("Core", "constant spindle speed"), keepSpindleSpeed, Step::spindleMode},
    {'G', 980, ModalGroup::retract, PROVEOUT_TEXT("Core", "cycles retract to the initial level"), retractToInitialLevel, Step::retract},
    {'G', 990, ModalGroup::retract, PROVEOUT_TEXT("Core", "cycles retract to the R plane"), retractToRLevel, Step::retract},
    {'M', 0, ModalGroup::stop, PROVEOUT_TEXT("Core", "program stop"), stopProgram, Step::stop},
    {'M', 10, ModalGroup::stop, PROVEOUT_TEXT("Core", "optional stop"), stopProgramOptionally, Step::stop},
    {'M', 20, ModalGroup::stop, PROVEOUT_TEXT("Core", "end of program"), endProgram, Step::stop},
    {'M', 30, ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle clockwise"), turnSpindleClockwise, Step::spindle, LetterSet("_")},
    {'M', 40, ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle counter-clockwise"), turnSpindleCounterClockwise, Step::spindle, LetterSet("_")},
    {'M', 50, ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle stop"), stopSpindle, Step::spindle, LetterSet("_")},
    {'M', 60, ModalGroup::toolChange, PROVEOUT_TEXT("Core", "tool change"), changeTool, Step::toolChange, {}, AxisUse::none, WithCompensation::refused},
    {'M', 70, ModalGroup::coolant, PROVEOUT_TEXT("Core", "mist coolant on"), switchMistOn, Step::coolant},
    {'M', 80, ModalGroup::coolant, PROVEOUT_TEXT("Core", "flood coolant on"), switchFloodOn, Step::coolant},
    {'M', 90, ModalGroup::coolant, PROVEOUT_TEXT("Core", "coolant off"), switchCoolantOff, Step::coolant},
    {'M', 300, ModalGroup::stop, PROVEOUT_TEXT("Core", "end of program, rewind"), endProgram, Step::stop},
};
// clang-format on

} // namespace

std::span<const CodeRow> basicCodes() {
    return kBasic;
}

} // namespace proveout
