// SPDX-License-Identifier: GPL-3.0-or-later
// Typical machines by kind and size, to begin with. A new one is one row.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/simulation/setup/machine.h"

namespace proveout {

struct MachineProfile {
    const char* key;   ///< stable, kebab-case
    const char* label; ///< marked with PROVEOUT_TEXT
    Machine machine;   ///< the place of the part is unknown
};

[[nodiscard]] std::span<const MachineProfile> machineProfiles();
/// The keys of all, separated by commas.
[[nodiscard]] std::string machineProfileKeys();
/// The machine of a profile with the part where it is in `placed`.
[[nodiscard]] Machine machineOf(const MachineProfile& profile, const Machine& placed);
/// Null: there is none of that key.
[[nodiscard]] const MachineProfile* findMachineProfile(std::string_view key);

} // namespace proveout
