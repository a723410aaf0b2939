// SPDX-License-Identifier: GPL-3.0-or-later
// The codes of Mach3 and Mach4 for milling, overriding the basic ones. Source: Using Mach3Mill, chapter 10;
// where Mach4 differs, Mach4 CNC Controller, Mill GCode Programming.
#include "core/nc/codes/code_rows.h"

#include <iterator>

#include "core/base/text.h"
#include "core/nc/codes/handlers.h"

namespace proveout {

namespace {

// clang-format off
constexpr CodeRow kMachRows[] = {
    {'G', 120, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "clockwise circular pocket"), millCircleClockwise, Step::nonModal, LetterSet("I"), AxisUse::takes, WithCompensation::refusedBeside},
    {'G', 130, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "counter-clockwise circular pocket"), millCircleCounterClockwise, Step::nonModal, LetterSet("I"), AxisUse::takes, WithCompensation::refusedBeside},
    {'G', 150, ModalGroup::polar, PROVEOUT_TEXT("Core", "polar coordinates off"), endPolar, Step::polar},
    {'G', 160, ModalGroup::polar, PROVEOUT_TEXT("Core", "polar coordinates on"), beginPolarHere, Step::polar},
    {'G', 281, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "seek the reference switches"), referenceAxes, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 310, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "skip motion (probe)"), skipMotion, Step::nonModal, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 430, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "tool length offset"), useNumberedLength, Step::toolLength, LetterSet("H"), AxisUse::none, WithCompensation::refused},
    {'G', 440, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "negative tool length offset"), subtractNumberedLength, Step::toolLength, LetterSet("H"), AxisUse::none, WithCompensation::refused},
    {'G', 510, ModalGroup::scaling, PROVEOUT_TEXT("Core", "scaling"), scaleByAxis, Step::scaling, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 541, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNumberedSystem, Step::workOffset, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'G', 590, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset 6, or by number"), selectNumberedSystem, Step::workOffset, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'G', 640, ModalGroup::pathControl, PROVEOUT_TEXT("Core", "path blending"), keepState, Step::pathControl, {}, AxisUse::none, WithCompensation::refused},
    {'G', 680, ModalGroup::rotation, PROVEOUT_TEXT("Core", "coordinate rotation"), turnByPoint, Step::rotation, LetterSet("ABXYRI"), AxisUse::takes, WithCompensation::refused},
    {'G', 690, ModalGroup::rotation, PROVEOUT_TEXT("Core", "coordinate rotation off"), endTurning, Step::rotation, {}, AxisUse::none, WithCompensation::refused},
    {'G', 700, ModalGroup::units, PROVEOUT_TEXT("Core", "inch"), setInch, Step::units},
    {'G', 710, ModalGroup::units, PROVEOUT_TEXT("Core", "millimetre"), setMillimetre, Step::units},
    {'M', 470, ModalGroup::stop, PROVEOUT_TEXT("Core", "restart the program"), beginAgain, Step::stop},
    {'M', 980, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "subprogram call"), callProgram, Step::subprogram, LetterSet("PLQ")},
};
// clang-format on

std::vector<CodeRow> rowsOfMach() {
    std::vector<CodeRow> rows(std::begin(kMachRows), std::end(kMachRows));
    auto g =
        sameRows(rs274Codes(), 'G', {40,  100, 280, 300, 400, 410, 420, 490, 520, 530, 610, 730, 810, 820,
                                     830, 840, 850, 860, 870, 880, 890, 901, 911, 920, 921, 922, 923});
    auto scaling = sameRows(fanucCodes(), 'G', {500});
    auto m = sameRows(rs274Codes(), 'M', {480, 490, 990});
    for (CodeRow& row : m) { // as in RS274/NGC; LinuxCNC is stricter
        row.withCompensation = WithCompensation::allowed;
        row.letters = row.tenths == 990 ? LetterSet() : LetterSet("P");
    }
    for (CodeRow& row : g) {
        if (row.group == ModalGroup::cutterCompensation && row.tenths != 400)
            row.letters = LetterSet("D");
    }
    rows.insert(rows.end(), g.begin(), g.end());
    rows.insert(rows.end(), scaling.begin(), scaling.end());
    rows.insert(rows.end(), m.begin(), m.end());
    return rows;
}

} // namespace

std::span<const CodeRow> machCodes() {
    static const std::vector<CodeRow> kRows = rowsOfMach();
    return kRows;
}

} // namespace proveout
