// SPDX-License-Identifier: GPL-3.0-or-later
// Where Haas's codes extend Fanuc's or differ from them. Source: HAAS Mill Operator's Manual.
#include "core/nc/codes/code_rows.h"

#include <iterator>

#include "core/base/text.h"
#include "core/nc/codes/handlers.h"

namespace proveout {

namespace {

// clang-format off
constexpr CodeRow kHaasRows[] = {
    {'G', 120, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "clockwise circular pocket"), millPocketClockwise, Step::nonModal, LetterSet("ZIKQDL"), AxisUse::takes, WithCompensation::refusedBeside},
    {'G', 130, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "counter-clockwise circular pocket"), millPocketCounterClockwise, Step::nonModal, LetterSet("ZIKQDL"), AxisUse::takes, WithCompensation::refusedBeside},
    {'G', 470, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "engraving of text"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 700, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "bolt hole circle"), drillBoltCircle, Step::nonModal, LetterSet("IJL"), AxisUse::takes, WithCompensation::refused},
    {'G', 710, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "bolt hole arc"), drillBoltArc, Step::nonModal, LetterSet("IJKL"), AxisUse::takes, WithCompensation::refused},
    {'G', 720, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "bolt holes along a line"), drillBoltLine, Step::nonModal, LetterSet("IJL"), AxisUse::takes, WithCompensation::refused},
    {'G', 730, ModalGroup::motion, PROVEOUT_TEXT("Core", "chip-breaking drilling cycle"), runCycle, Step::motion, LetterSet("XYZRLQPIJK"), AxisUse::none, WithCompensation::refused},
    {'G', 740, ModalGroup::motion, PROVEOUT_TEXT("Core", "left-hand tapping cycle"), runCycle, Step::motion, LetterSet("XYZRLJ"), AxisUse::none, WithCompensation::refused},
    {'G', 760, ModalGroup::motion, PROVEOUT_TEXT("Core", "fine boring cycle"), runCycle, Step::motion, LetterSet("XYZRLQPIJ"), AxisUse::none, WithCompensation::refused},
    {'G', 770, ModalGroup::motion, PROVEOUT_TEXT("Core", "back boring cycle"), runCycle, Step::motion, LetterSet("XYZRLQIJ"), AxisUse::none, WithCompensation::refused},
    {'G', 830, ModalGroup::motion, PROVEOUT_TEXT("Core", "deep-hole drilling cycle"), runCycle, Step::motion, LetterSet("XYZRLQPIJK"), AxisUse::none, WithCompensation::refused},
    {'G', 840, ModalGroup::motion, PROVEOUT_TEXT("Core", "right-hand tapping cycle"), runCycle, Step::motion, LetterSet("XYZRLJ"), AxisUse::none, WithCompensation::refused},
    {'G', 860, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, stop and rapid out"), runCycle, Step::motion, LetterSet("XYZRL"), AxisUse::none, WithCompensation::refused},
    {'G', 870, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, stop and manual out"), runCycle, Step::motion, LetterSet("XYZRL"), AxisUse::none, WithCompensation::refused},
    {'G', 880, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle, dwell, stop and manual out"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 890, ModalGroup::motion, PROVEOUT_TEXT("Core", "boring cycle with dwell, feed out"), runCycle, Step::motion, LetterSet("XYZRLP"), AxisUse::none, WithCompensation::refused},
    {'G', 1000, ModalGroup::mirroring, PROVEOUT_TEXT("Core", "mirroring off"), endMirror, Step::mirroring, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 1010, ModalGroup::mirroring, PROVEOUT_TEXT("Core", "mirroring"), mirrorAboutZero, Step::mirroring, LetterSet("XYZ"), AxisUse::takes, WithCompensation::refused},
    {'G', 1030, ModalGroup::lookAhead, PROVEOUT_TEXT("Core", "limit of the look-ahead"), keepState, Step::lookAhead, LetterSet("P")},
    {'G', 1070, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "cylindrical mapping"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 1100, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1110, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1120, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1130, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1140, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1150, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1160, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1170, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1180, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1190, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1200, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1210, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1220, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1230, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1240, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1250, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1260, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1270, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1280, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1290, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectNamedSystem, Step::workOffset, {}, AxisUse::none, WithCompensation::refused},
    {'G', 1500, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "pocket of any shape"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 1540, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset"), selectAdditionalSystem, Step::workOffset, LetterSet("P"), AxisUse::none, WithCompensation::refused},
    {'G', 1870, ModalGroup::lookAhead, PROVEOUT_TEXT("Core", "smoothness of the path"), keepState, Step::lookAhead, LetterSet("PE")},
    {'M', 160, ModalGroup::toolChange, PROVEOUT_TEXT("Core", "tool change"), changeTool, Step::toolChange, {}, AxisUse::none, WithCompensation::refused},
    {'M', 970, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "local subprogram call"), callLocalSubprogram, Step::subprogram, LetterSet("PL")},
};
// clang-format on

std::vector<CodeRow> rowsOfHaas() {
    std::vector<CodeRow> rows(std::begin(kHaasRows), std::end(kHaasRows));
    const auto cycles = sameRows(rs274Codes(), 'G', {810, 820, 850});
    rows.insert(rows.end(), cycles.begin(), cycles.end());
    return rows;
}

} // namespace

std::span<const CodeRow> haasCodes() {
    static const std::vector<CodeRow> kRows = rowsOfHaas();
    return kRows;
}

} // namespace proveout
