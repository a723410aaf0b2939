// SPDX-License-Identifier: GPL-3.0-or-later
// The modal groups: one code of each is in force. One table for both directions: which code a state means,
// and which code restores a state. Macros, saved modal states, help and the control panel read it; the effect
// of a code on the state is in its own row (codes.h).
#pragma once

#include <cstdint>
#include <span>

#include "core/nc/codes/codes.h"

namespace proveout {

struct MachineState;

/// A code of a group, as tenths of its number: 170 for G17.
using CodeOfState = int (*)(const MachineState&, const Dialect&);

/// Who reads the code in force of a group, besides macros and hover help; bits.
enum GroupReader : std::uint8_t {
    kReadByNone = 0,
    kReadByPanel = 1,   ///< the control panel lists it
    kReadByRestore = 2, ///< M72 and a return after M73 restore it, by the one block that restores all groups
};

struct ModalGroupRow {
    ModalGroup group;
    const char* name;                   ///< marked with PROVEOUT_TEXT
    CodeOfState inForce = nullptr;      ///< null: the state does not store it
    std::uint8_t readers = kReadByNone; ///< GroupReader bits
    char letter = 'G';                  ///< of that code
    CodeOfState restores = nullptr; ///< if LinuxCNC restores the group by a code other than the one in force
};

/// In the order of ModalGroup.
[[nodiscard]] std::span<const ModalGroupRow> modalGroups();

[[nodiscard]] const ModalGroupRow& rowOf(ModalGroup group);

/// For the user interface; marked with PROVEOUT_TEXT.
[[nodiscard]] const char* nameOf(ModalGroup group);

// The functions that the rows name, for the libraries that know the state.
[[nodiscard]] int motionInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int planeInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int distanceInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int arcDistanceInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int feedModeInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int unitsInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int compensationInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int toolLengthInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int toolLengthRestored(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int retractInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int workOffsetInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int spindleModeInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int polarInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int mirroringInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int scalingInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int rotationInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int macroCallInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int shiftInForce(const MachineState& state, const Dialect& dialect);
[[nodiscard]] int spindleInForce(const MachineState& state, const Dialect& dialect);

} // namespace proveout
