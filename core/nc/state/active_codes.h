// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nc/codes/codes.h"
#include "core/nc/state/machine_state.h"

namespace proveout {

/// The code of a modal group that is in force, as tenths of its number: 170 for G17. For groups that the
/// state stores (modal_groups.h); -1 for others. A motion group without a motion code is at G80.
[[nodiscard]] int activeCode(const MachineState& state, ModalGroup group, const Dialect& dialect);

/// The number of the code that restores the group, for groups that the state stores.
[[nodiscard]] double restoringCode(const MachineState& state, ModalGroup group, const Dialect& dialect);

} // namespace proveout
