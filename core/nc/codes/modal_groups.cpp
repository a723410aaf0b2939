// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/modal_groups.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "core/base/text.h"

namespace proveout {

namespace {

// In the order of ModalGroup.
constexpr ModalGroupRow kGroups[] = {
    {ModalGroup::nonModal, PROVEOUT_TEXT("Core", "in its block only")},
    {ModalGroup::shiftEnd, PROVEOUT_TEXT("Core", "in its block only"), shiftInForce, kReadByRestore},
    {ModalGroup::motion, PROVEOUT_TEXT("Core", "motion"), motionInForce, kReadByPanel},
    {ModalGroup::motionOff, PROVEOUT_TEXT("Core", "motion")},
    {ModalGroup::plane, PROVEOUT_TEXT("Core", "plane"), planeInForce, kReadByPanel | kReadByRestore},
    {ModalGroup::distance, PROVEOUT_TEXT("Core", "distance mode"), distanceInForce,
     kReadByPanel | kReadByRestore},
    {ModalGroup::arcDistance, PROVEOUT_TEXT("Core", "arc distance mode"), arcDistanceInForce,
     kReadByPanel | kReadByRestore},
    {ModalGroup::feedMode, PROVEOUT_TEXT("Core", "feed mode"), feedModeInForce,
     kReadByPanel | kReadByRestore},
    {ModalGroup::units, PROVEOUT_TEXT("Core", "unit"), unitsInForce, kReadByPanel},
    {ModalGroup::cutterCompensation, PROVEOUT_TEXT("Core", "cutter compensation"), compensationInForce,
     kReadByPanel | kReadByRestore},
    {ModalGroup::toolLength, PROVEOUT_TEXT("Core", "tool length"), toolLengthInForce,
     kReadByPanel | kReadByRestore, 'G', toolLengthRestored},
    {ModalGroup::retract, PROVEOUT_TEXT("Core", "canned-cycle return"), retractInForce,
     kReadByPanel | kReadByRestore},
    {ModalGroup::workOffset, PROVEOUT_TEXT("Core", "work offset"), workOffsetInForce,
     kReadByPanel | kReadByRestore},
    {ModalGroup::pathControl, PROVEOUT_TEXT("Core", "path control")},
    {ModalGroup::spindleMode, PROVEOUT_TEXT("Core", "spindle mode"), spindleModeInForce,
     kReadByPanel | kReadByRestore},
    {ModalGroup::polar, PROVEOUT_TEXT("Core", "polar coordinates"), polarInForce, kReadByPanel},
    {ModalGroup::scaling, PROVEOUT_TEXT("Core", "scaling"), scalingInForce, kReadByPanel},
    {ModalGroup::mirroring, PROVEOUT_TEXT("Core", "mirroring"), mirroringInForce, kReadByPanel},
    {ModalGroup::rotation, PROVEOUT_TEXT("Core", "coordinate rotation"), rotationInForce, kReadByPanel},
    {ModalGroup::exactStop, PROVEOUT_TEXT("Core", "path control")},
    {ModalGroup::lookAhead, PROVEOUT_TEXT("Core", "look-ahead")},
    {ModalGroup::diameterMode, PROVEOUT_TEXT("Core", "diameter mode")},
    {ModalGroup::macroCall, PROVEOUT_TEXT("Core", "macro call"), macroCallInForce},
    {ModalGroup::stop, PROVEOUT_TEXT("Core", "stop")},
    {ModalGroup::inputOutput, PROVEOUT_TEXT("Core", "inputs and outputs")},
    {ModalGroup::toolChange, PROVEOUT_TEXT("Core", "tool change")},
    {ModalGroup::spindle, PROVEOUT_TEXT("Core", "spindle"), spindleInForce, kReadByPanel | kReadByRestore,
     'M'},
    {ModalGroup::coolant, PROVEOUT_TEXT("Core", "coolant")},
    {ModalGroup::overrides, PROVEOUT_TEXT("Core", "overrides")},
    {ModalGroup::modalSave, PROVEOUT_TEXT("Core", "saved modal state")},
    {ModalGroup::subprogram, PROVEOUT_TEXT("Core", "subprogram")},
    {ModalGroup::tapping, PROVEOUT_TEXT("Core", "tapping")},
};
static_assert(std::size(kGroups) == static_cast<std::size_t>(ModalGroup::count));
static_assert(std::ranges::is_sorted(kGroups, {}, &ModalGroupRow::group));

} // namespace

std::span<const ModalGroupRow> modalGroups() {
    return kGroups;
}

const ModalGroupRow& rowOf(ModalGroup group) {
    return kGroups[static_cast<std::size_t>(group)];
}

const char* nameOf(ModalGroup group) {
    return rowOf(group).name;
}

} // namespace proveout
