// SPDX-License-Identifier: GPL-3.0-or-later
// M codes that switch a device of the machine and move no axis. Codes that affect the spindle, the coolant of
// M8, the tool or the part (pallet change, tool unclamp, user relays) are not included. Sources: P. Smid, CNC
// Programming Handbook, miscellaneous functions for milling; HAAS Mill Operator's Manual.
#include "core/nc/codes/code_rows.h"

#include <iterator>

#include "core/base/text.h"

namespace proveout {

namespace {

constexpr CodeRow function(int number, const char* name) {
    CodeRow row{'M', number * 10, ModalGroup::nonModal, name};
    row.ignored = true;
    return row;
}

/// The machine builder defines their meaning; most follow these.
constexpr CodeRow kFanucFunctions[] = {
    function(10, PROVEOUT_TEXT("Core", "clamp of a rotary axis or pallet on")),
    function(11, PROVEOUT_TEXT("Core", "clamp of a rotary axis or pallet off")),
    function(41, PROVEOUT_TEXT("Core", "low spindle gear")),
    function(42, PROVEOUT_TEXT("Core", "high spindle gear")),
    function(48, PROVEOUT_TEXT("Core", "overrides on")),
    function(49, PROVEOUT_TEXT("Core", "overrides off")),
    function(78, PROVEOUT_TEXT("Core", "clamp of the B axis on")),
    function(79, PROVEOUT_TEXT("Core", "clamp of the B axis off")),
};

constexpr CodeRow kHaasFunctions[] = {
    function(10, PROVEOUT_TEXT("Core", "brake of the 4th axis on")),
    function(11, PROVEOUT_TEXT("Core", "brake of the 4th axis off")),
    function(12, PROVEOUT_TEXT("Core", "brake of the 5th axis on")),
    function(13, PROVEOUT_TEXT("Core", "brake of the 5th axis off")),
    function(17, PROVEOUT_TEXT("Core", "pallet unclamped, door open")),
    function(18, PROVEOUT_TEXT("Core", "pallet clamped, door closed")),
    function(31, PROVEOUT_TEXT("Core", "chip conveyor on")),
    function(33, PROVEOUT_TEXT("Core", "chip conveyor off")),
    function(34, PROVEOUT_TEXT("Core", "coolant nozzle one step on")),
    function(35, PROVEOUT_TEXT("Core", "coolant nozzle one step back")),
    function(36, PROVEOUT_TEXT("Core", "pallet part ready")),
    function(73, PROVEOUT_TEXT("Core", "air through the tool on")),
    function(74, PROVEOUT_TEXT("Core", "air through the tool off")),
    function(76, PROVEOUT_TEXT("Core", "display off")),
    function(77, PROVEOUT_TEXT("Core", "display on")),
    function(80, PROVEOUT_TEXT("Core", "door open")),
    function(81, PROVEOUT_TEXT("Core", "door closed")),
    function(83, PROVEOUT_TEXT("Core", "air jet on")),
    function(84, PROVEOUT_TEXT("Core", "air jet off")),
    function(88, PROVEOUT_TEXT("Core", "coolant through the spindle on")),
    function(89, PROVEOUT_TEXT("Core", "coolant through the spindle off")),
    function(130, PROVEOUT_TEXT("Core", "image shown on the display")),
    function(131, PROVEOUT_TEXT("Core", "image on the display closed")),
    function(138, PROVEOUT_TEXT("Core", "spindle speed variation on")),
    function(139, PROVEOUT_TEXT("Core", "spindle speed variation off")),
    function(158, PROVEOUT_TEXT("Core", "mist extractor on")),
    function(159, PROVEOUT_TEXT("Core", "mist extractor off")),
};

std::vector<CodeRow> functionsOfHaas() {
    std::vector<CodeRow> rows(std::begin(kHaasFunctions), std::end(kHaasFunctions));
    const auto gears = sameRows(kFanucFunctions, 'M', {410, 420});
    rows.insert(rows.end(), gears.begin(), gears.end());
    return rows;
}

} // namespace

std::span<const CodeRow> fanucFunctions() {
    return kFanucFunctions;
}

std::span<const CodeRow> haasFunctions() {
    static const std::vector<CodeRow> kRows = functionsOfHaas();
    return kRows;
}

} // namespace proveout
