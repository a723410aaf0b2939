// SPDX-License-Identifier: GPL-3.0-or-later
// The effect of findings on the exit code of the command line.
#pragma once

#include <cstdint>

#include "core/base/finding_row.h"

namespace proveout {

/// The values are the exit codes themselves.
enum class ExitEffect : std::uint8_t {
    none = 0,       ///< done, nothing found
    faults = 1,     ///< the program would cause damage
    unverified = 2, ///< something in the program could not be checked
    unusable = 3,   ///< input that cannot be used, output that cannot be written
};

/// Of a finding about a program or a part that was read: `faults` for a fault; `unverified` for an error or
/// anything that leaves the rest unverified; otherwise `none`.
[[nodiscard]] ExitEffect exitEffect(Severity severity, bool unverified);

/// Of a row of `table`: as above, except that an error in refused input ends a command.
[[nodiscard]] ExitEffect exitEffect(const FindingTable& table, const FindingRow& row);

/// The one that decides the exit code: unusable before faults before unverified before none.
[[nodiscard]] ExitEffect worse(ExitEffect one, ExitEffect other);

} // namespace proveout
