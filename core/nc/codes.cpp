// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "core/base/text.h"
#include "core/nc/handlers.h"

namespace proveout {

namespace {

// A code that is known but not supported has a name, and says what it does with the axis words of its block.
// clang-format off
constexpr CodeRow kCodes[] = {
    {'G', 0, ModalGroup::motion, PROVEOUT_TEXT("Core", "rapid motion"), moveRapid, Step::motion, LetterSet("XYZ")},
    {'G', 10, ModalGroup::motion, PROVEOUT_TEXT("Core", "straight feed"), moveFeed, Step::motion, LetterSet("XYZ")},
    {'G', 20, ModalGroup::motion, PROVEOUT_TEXT("Core", "clockwise arc"), moveArcClockwise, Step::motion, LetterSet("XYZIJKRP")},
    {'G', 30, ModalGroup::motion, PROVEOUT_TEXT("Core", "counter-clockwise arc"), moveArcCounterClockwise, Step::motion, LetterSet("XYZIJKRP")},
    {'G', 40, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "dwell"), dwell, Step::dwell, LetterSet("P")},
    {'G', 50, ModalGroup::motion, PROVEOUT_TEXT("Core", "cubic spline"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 51, ModalGroup::motion, PROVEOUT_TEXT("Core", "quadratic spline"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 52, ModalGroup::motion, PROVEOUT_TEXT("Core", "NURBS block"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 53, ModalGroup::motion, PROVEOUT_TEXT("Core", "end of NURBS block"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 70, ModalGroup::diameterMode, PROVEOUT_TEXT("Core", "lathe diameter mode")},
    {'G', 80, ModalGroup::diameterMode, PROVEOUT_TEXT("Core", "lathe radius mode")},
    {'G', 90, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "exact stop in one block")},
    {'G', 100, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "set offsets"), setOffsets, Step::nonModal, LetterSet("LPXYZRIJQABCUVW"), AxisUse::takes},
    {'G', 120, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "clockwise circular pocket"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 130, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "counter-clockwise circular pocket"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 150, ModalGroup::transformation, PROVEOUT_TEXT("Core", "polar coordinates off")},
    {'G', 160, ModalGroup::transformation, PROVEOUT_TEXT("Core", "polar coordinates on"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 170, ModalGroup::plane, PROVEOUT_TEXT("Core", "XY plane"), setPlaneXy, Step::plane},
    {'G', 171, ModalGroup::plane, PROVEOUT_TEXT("Core", "UV plane")},
    {'G', 180, ModalGroup::plane, PROVEOUT_TEXT("Core", "ZX plane"), setPlaneZx, Step::plane},
    {'G', 181, ModalGroup::plane, PROVEOUT_TEXT("Core", "WU plane")},
    {'G', 190, ModalGroup::plane, PROVEOUT_TEXT("Core", "YZ plane"), setPlaneYz, Step::plane},
    {'G', 191, ModalGroup::plane, PROVEOUT_TEXT("Core", "VW plane")},
    {'G', 200, ModalGroup::units, PROVEOUT_TEXT("Core", "inch"), setInch, Step::units},
    {'G', 210, ModalGroup::units, PROVEOUT_TEXT("Core", "millimetre"), setMillimetre, Step::units},
    {'G', 280, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "go to reference position"), goHome, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 281, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "store reference position"), storeHome, Step::nonModal, {}, AxisUse::none, WithCompensation::refused},
    {'G', 300, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "go to second reference position"), goToSecondReference, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 301, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "store second reference position"), storeSecondReference, Step::nonModal, {}, AxisUse::none, WithCompensation::refused},
    {'G', 310, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "skip motion (probe)"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 330, ModalGroup::motion, PROVEOUT_TEXT("Core", "spindle-synchronised motion"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 331, ModalGroup::motion, PROVEOUT_TEXT("Core", "rigid tapping"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 382, ModalGroup::motion, PROVEOUT_TEXT("Core", "probe toward the part, error on failure"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 383, ModalGroup::motion, PROVEOUT_TEXT("Core", "probe toward the part"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 384, ModalGroup::motion, PROVEOUT_TEXT("Core", "probe away from the part, error on failure"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 385, ModalGroup::motion, PROVEOUT_TEXT("Core", "probe away from the part"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 400, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation off"), endCompensation, Step::cutterCompensation},
    {'G', 410, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation left"), compensateLeft, Step::cutterCompensation, LetterSet("D")},
    {'G', 411, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "dynamic cutter compensation left"), compensateLeftByDiameter, Step::cutterCompensation, LetterSet("D")},
    {'G', 420, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation right"), compensateRight, Step::cutterCompensation, LetterSet("D")},
    {'G', 421, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "dynamic cutter compensation right"), compensateRightByDiameter, Step::cutterCompensation, LetterSet("D")},
    {'G', 430, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "tool length offset"), useToolLength, Step::toolLength, LetterSet("H"), AxisUse::none, WithCompensation::refused},
    {'G', 431, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "dynamic tool length offset"), useGivenLength, Step::toolLength, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 432, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "additional tool length offset"), addToolLength, Step::toolLength, LetterSet("HXYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 440, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "negative tool length offset")},
    {'G', 490, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "tool length offset off"), cancelToolLength, Step::toolLength, {}, AxisUse::none, WithCompensation::refused},
    {'G', 500, ModalGroup::transformation, PROVEOUT_TEXT("Core", "scaling off")},
    {'G', 501, ModalGroup::transformation, PROVEOUT_TEXT("Core", "mirroring off"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 510, ModalGroup::transformation, PROVEOUT_TEXT("Core", "scaling"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 511, ModalGroup::transformation, PROVEOUT_TEXT("Core", "mirroring"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 520, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "local coordinate shift"), shiftLocally, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 530, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "machine coordinates"), keepState, Step::nonModal, LetterSet("XYZ"), AxisUse::machine},
    {'G', 540, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 1"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 541, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset")},
    {'G', 550, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 2"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 560, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 3"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 570, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 4"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 580, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 5"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 590, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 6"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 591, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 7"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 592, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 8"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 593, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 9"), selectWorkOffset, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 610, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "exact path"), keepState, Step::pathControl, {}, AxisUse::none, WithCompensation::refused},
    {'G', 611, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "exact stop"), keepState, Step::pathControl, {}, AxisUse::none, WithCompensation::refused},
    {'G', 640, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "path blending"), keepState, Step::pathControl, LetterSet("PQ"), AxisUse::none, WithCompensation::refused},
    {'G', 650, ModalGroup::macroCall, PROVEOUT_TEXT("Core", "macro call"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 660, ModalGroup::macroCall, PROVEOUT_TEXT("Core", "modal macro call"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 670, ModalGroup::macroCall, PROVEOUT_TEXT("Core", "modal macro call off")},
    {'G', 680, ModalGroup::transformation, PROVEOUT_TEXT("Core", "coordinate rotation"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 690, ModalGroup::transformation, PROVEOUT_TEXT("Core", "coordinate rotation off")},
    {'G', 700, ModalGroup::motion, PROVEOUT_TEXT("Core", "finishing cycle or bolt circle"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 710, ModalGroup::motion, PROVEOUT_TEXT("Core", "roughing cycle or bolt arc"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 720, ModalGroup::motion, PROVEOUT_TEXT("Core", "facing cycle or bolt line"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 730, ModalGroup::motion, PROVEOUT_TEXT("Core", "chip-breaking drilling cycle"), runCycle, Step::motion, LetterSet("XYZRLQ"), AxisUse::none, WithCompensation::refused},
    {'G', 740, ModalGroup::motion, PROVEOUT_TEXT("Core", "left-hand tapping cycle"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 760, ModalGroup::motion, PROVEOUT_TEXT("Core", "threading or fine boring cycle"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 800, ModalGroup::motionOff, PROVEOUT_TEXT("Core", "motion mode off"), keepState, Step::motion},
    {'G', 810, ModalGroup::motion, PROVEOUT_TEXT("Core", "drilling cycle"), runCycle, Step::motion, LetterSet("XYZRL"), AxisUse::none, WithCompensation::refused},
    {'G', 820, ModalGroup::motion, PROVEOUT_TEXT("Core", "drilling cycle with dwell"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 830, ModalGroup::motion, PROVEOUT_TEXT("Core", "deep-hole drilling cycle"), runCycle, Step::motion, LetterSet("XYZRLQ"), AxisUse::none, WithCompensation::refused},
    {'G', 840, ModalGroup::motion, PROVEOUT_TEXT("Core", "right-hand tapping cycle"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 850, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, feed out"), runCycle, Step::motion, LetterSet("XYZRL"), AxisUse::none, WithCompensation::refused},
    {'G', 860, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, stop and rapid out"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 870, ModalGroup::motion, PROVEOUT_TEXT("Core", "back boring cycle"), runCycle, Step::motion, LetterSet("XYZRLIJK"), AxisUse::none, WithCompensation::refused},
    {'G', 880, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, manual out"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 890, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle with dwell"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 900, ModalGroup::distance, PROVEOUT_TEXT("Core", "absolute distances"), setAbsolute, Step::distance},
    {'G', 901, ModalGroup::arcDistance, PROVEOUT_TEXT("Core", "absolute arc centres"), setArcCentreAbsolute, Step::arcDistance},
    {'G', 910, ModalGroup::distance, PROVEOUT_TEXT("Core", "incremental distances"), setIncremental, Step::distance},
    {'G', 911, ModalGroup::arcDistance, PROVEOUT_TEXT("Core", "incremental arc centres"), setArcCentreIncremental, Step::arcDistance},
    {'G', 920, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "coordinate shift"), shiftCoordinates, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 921, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "coordinate shift off, cleared"), clearShift, Step::nonModal},
    {'G', 922, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "coordinate shift off"), suspendShift, Step::nonModal},
    {'G', 923, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "coordinate shift restored"), restoreShift, Step::nonModal},
    {'G', 930, ModalGroup::feedMode, PROVEOUT_TEXT("Core", "inverse time feed"), feedInverseTime, Step::feedMode},
    {'G', 940, ModalGroup::feedMode, PROVEOUT_TEXT("Core", "feed per minute"), feedPerMinute, Step::feedMode},
    {'G', 950, ModalGroup::feedMode, PROVEOUT_TEXT("Core", "feed per revolution"), feedPerRevolution, Step::feedMode},
    {'G', 960, ModalGroup::spindleMode, PROVEOUT_TEXT("Core", "constant surface speed")},
    {'G', 970, ModalGroup::spindleMode, PROVEOUT_TEXT("Core", "constant spindle speed"), keepState, Step::spindleMode, LetterSet("D")},
    {'G', 980, ModalGroup::retract, PROVEOUT_TEXT("Core", "cycles retract to the initial level"), retractToInitialLevel, Step::retract},
    {'G', 990, ModalGroup::retract, PROVEOUT_TEXT("Core", "cycles retract to the R level"), retractToRLevel, Step::retract},
    {'M', 0, ModalGroup::stop, PROVEOUT_TEXT("Core", "program stop"), stopProgram, Step::stop},
    {'M', 10, ModalGroup::stop, PROVEOUT_TEXT("Core", "optional stop"), stopProgramOptionally, Step::stop},
    {'M', 20, ModalGroup::stop, PROVEOUT_TEXT("Core", "end of program"), endProgram, Step::stop},
    {'M', 30, ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle clockwise"), turnSpindleClockwise, Step::spindle},
    {'M', 40, ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle counter-clockwise"), turnSpindleCounterClockwise, Step::spindle},
    {'M', 50, ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle stop"), stopSpindle, Step::spindle},
    {'M', 60, ModalGroup::toolChange, PROVEOUT_TEXT("Core", "tool change"), changeTool, Step::toolChange, {}, AxisUse::none, WithCompensation::refused},
    {'M', 70, ModalGroup::coolant, PROVEOUT_TEXT("Core", "mist coolant on"), switchMistOn, Step::coolant},
    {'M', 80, ModalGroup::coolant, PROVEOUT_TEXT("Core", "flood coolant on"), switchFloodOn, Step::coolant},
    {'M', 90, ModalGroup::coolant, PROVEOUT_TEXT("Core", "coolant off"), switchCoolantOff, Step::coolant},
    {'M', 190, ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle orientation"), keepState, Step::spindleOrientation, LetterSet("RPQ")},
    {'M', 290, ModalGroup::spindle, PROVEOUT_TEXT("Core", "rigid tapping")},
    {'M', 300, ModalGroup::stop, PROVEOUT_TEXT("Core", "end of program, rewind"), endProgram, Step::stop},
    {'M', 480, ModalGroup::overrides, PROVEOUT_TEXT("Core", "overrides on"), keepState, Step::overrides, LetterSet("P")},
    {'M', 490, ModalGroup::overrides, PROVEOUT_TEXT("Core", "overrides off"), keepState, Step::overrides, LetterSet("P")},
    {'M', 500, ModalGroup::overrides, PROVEOUT_TEXT("Core", "feed override"), keepState, Step::overrides, LetterSet("P")},
    {'M', 510, ModalGroup::overrides, PROVEOUT_TEXT("Core", "spindle override"), keepState, Step::overrides, LetterSet("P")},
    {'M', 520, ModalGroup::overrides, PROVEOUT_TEXT("Core", "adaptive feed"), keepState, Step::overrides, LetterSet("P")},
    {'M', 530, ModalGroup::overrides, PROVEOUT_TEXT("Core", "feed stop"), keepState, Step::overrides, LetterSet("P")},
    {'M', 600, ModalGroup::stop, PROVEOUT_TEXT("Core", "pallet change"), changePallet, Step::stop},
    {'M', 610, ModalGroup::toolChange, PROVEOUT_TEXT("Core", "set the tool number"), setToolNumber, Step::toolChange, LetterSet("Q")},
    {'M', 620, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "digital output on, synchronised"), keepState, Step::inputOutput, LetterSet("P")},
    {'M', 630, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "digital output off, synchronised"), keepState, Step::inputOutput, LetterSet("P")},
    {'M', 640, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "digital output on"), keepState, Step::inputOutput, LetterSet("P")},
    {'M', 650, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "digital output off"), keepState, Step::inputOutput, LetterSet("P")},
    {'M', 660, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "wait for an input")},
    {'M', 670, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "analog output, synchronised"), keepState, Step::inputOutput, LetterSet("EQ")},
    {'M', 680, ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "analog output"), keepState, Step::inputOutput, LetterSet("EQ")},
    {'M', 700, ModalGroup::modalSave, PROVEOUT_TEXT("Core", "save modal state")},
    {'M', 710, ModalGroup::modalSave, PROVEOUT_TEXT("Core", "discard modal state")},
    {'M', 720, ModalGroup::modalSave, PROVEOUT_TEXT("Core", "restore modal state")},
    {'M', 730, ModalGroup::modalSave, PROVEOUT_TEXT("Core", "save modal state, restored at the end")},
    {'M', 970, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "local subprogram call")},
    {'M', 980, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "subprogram call"), callProgram, Step::subprogram, LetterSet("PL")},
    {'M', 990, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "end of subprogram"), returnFromProgram, Step::subprogram},
};
// clang-format on

constexpr LetterRow kLetters[] = {
    {'@', PROVEOUT_TEXT("Core", "polar radius")},
    {'A', PROVEOUT_TEXT("Core", "rotary axis about X")},
    {'B', PROVEOUT_TEXT("Core", "rotary axis about Y")},
    {'C', PROVEOUT_TEXT("Core", "rotary axis about Z")},
    {'D', PROVEOUT_TEXT("Core", "cutter compensation number")},
    {'E', PROVEOUT_TEXT("Core", "parameter of a code")},
    {'F', PROVEOUT_TEXT("Core", "feed rate"), setFeed, Step::feedRate},
    {'H', PROVEOUT_TEXT("Core", "tool length offset number")},
    {'I', PROVEOUT_TEXT("Core", "arc centre in X")},
    {'J', PROVEOUT_TEXT("Core", "arc centre in Y")},
    {'K', PROVEOUT_TEXT("Core", "arc centre in Z")},
    {'L', PROVEOUT_TEXT("Core", "repeats")},
    {'N', PROVEOUT_TEXT("Core", "block number")},
    {'O', PROVEOUT_TEXT("Core", "program number")},
    {'P', PROVEOUT_TEXT("Core", "dwell in seconds, turns of an arc, or a parameter")},
    {'Q', PROVEOUT_TEXT("Core", "parameter of a code")},
    {'R', PROVEOUT_TEXT("Core", "arc radius, or a retract level")},
    {'S', PROVEOUT_TEXT("Core", "spindle speed in revolutions per minute"), setSpindleSpeed,
     Step::spindleSpeed},
    {'T', PROVEOUT_TEXT("Core", "tool number"), selectTool, Step::toolSelection},
    {'U', PROVEOUT_TEXT("Core", "second axis along X")},
    {'V', PROVEOUT_TEXT("Core", "second axis along Y")},
    {'W', PROVEOUT_TEXT("Core", "second axis along Z")},
    {'X', PROVEOUT_TEXT("Core", "X coordinate")},
    {'Y', PROVEOUT_TEXT("Core", "Y coordinate")},
    {'Z', PROVEOUT_TEXT("Core", "Z coordinate")},
    {'^', PROVEOUT_TEXT("Core", "polar angle in degrees")},
};

constexpr int kTenths = 1000; ///< codes up to G99.9 and M99.9

/// Row numbers plus one, by ten times the number of the code; 0: no row.
constexpr std::array<std::uint8_t, kTenths> indexOf(char letter) {
    static_assert(std::size(kCodes) < 255);
    std::array<std::uint8_t, kTenths> index{};
    for (std::size_t i = 0; i < std::size(kCodes); ++i) {
        if (kCodes[i].letter == letter)
            index[static_cast<std::size_t>(kCodes[i].tenths)] = static_cast<std::uint8_t>(i + 1);
    }
    return index;
}

constexpr auto kGIndex = indexOf('G');
constexpr auto kMIndex = indexOf('M');

} // namespace

std::span<const CodeRow> codes() {
    return kCodes;
}

const CodeRow* findCode(char letter, int tenths) {
    if (tenths < 0 || tenths >= kTenths || (letter != 'G' && letter != 'M'))
        return nullptr;
    const std::size_t at = (letter == 'G' ? kGIndex : kMIndex)[static_cast<std::size_t>(tenths)];
    return at == 0 ? nullptr : &kCodes[at - 1];
}

const CodeRow* findCode(const Word& word) {
    const double tenths = word.value * 10;
    if (tenths < 0 || tenths >= kTenths || std::abs(tenths - std::round(tenths)) > 1e-6)
        return nullptr;
    return findCode(word.letter, static_cast<int>(std::lround(tenths)));
}

std::span<const LetterRow> letters() {
    return kLetters;
}

} // namespace proveout
