// SPDX-License-Identifier: GPL-3.0-or-later
// The codes of grbl 1.1 for milling. Source: its documentation and source.
#include "core/nc/codes/code_rows.h"

#include <algorithm>
#include <iterator>

#include "core/base/text.h"
#include "core/nc/codes/handlers.h"

namespace proveout {

namespace {

// clang-format off
constexpr CodeRow kGrblRows[] = {
    {'G', 100, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "set offsets"), setOffsets, Step::nonModal, LetterSet("LPXYZ"), AxisUse::takes},
    {'G', 400, ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation off"), keepState, Step::cutterCompensation},
    {'G', 431, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "dynamic tool length offset"), useGivenLength, Step::toolLength, LetterSet("Z"), AxisUse::takes},
    {'G', 490, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "tool length offset off"), cancelToolLength, Step::toolLength, {}, AxisUse::takes},
    {'M', 10, ModalGroup::stop, PROVEOUT_TEXT("Core", "optional stop"), ignoreOptionalStop, Step::stop},
    {'M', 70, ModalGroup::coolant, PROVEOUT_TEXT("Core", "mist coolant on"), switchMistWhereBuilt, Step::coolant},
};
// clang-format on

void append(std::vector<CodeRow>& rows, const std::vector<CodeRow>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
}

std::vector<CodeRow> rowsOfGrbl() {
    std::vector<CodeRow> rows(std::begin(kGrblRows), std::end(kGrblRows));
    append(rows, sameRows(basicCodes(), 'G', {0,   10,  20,  30,  170, 180, 190, 200, 210, 540,
                                              550, 560, 570, 580, 590, 800, 900, 910, 930, 940}));
    append(rows, sameRows(basicCodes(), 'M', {0, 20, 30, 40, 50, 80, 90, 300}));
    append(rows, sameRows(rs274Codes(), 'G',
                          {40, 280, 281, 300, 301, 382, 383, 384, 385, 530, 610, 911, 920, 921}));
    return rows;
}

} // namespace

std::span<const CodeRow> grblCodes() {
    static const std::vector<CodeRow> kRows = rowsOfGrbl();
    return kRows;
}

} // namespace proveout
