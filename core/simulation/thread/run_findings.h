// SPDX-License-Identifier: GPL-3.0-or-later
// Findings that end a run of the simulation.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::run_finding {

inline constexpr FindingRow kOutOfMemory{
    Severity::error,
    false,
    "out-of-memory",
    PROVEOUT_TEXT("Core", "Out of memory"),
    PROVEOUT_TEXT("Core", "There is not enough memory for the simulation."),
    ""};
inline constexpr FindingRow kInternalError{Severity::error,
                                           false,
                                           "internal-error",
                                           PROVEOUT_TEXT("Core", "Internal error"),
                                           PROVEOUT_TEXT("Core", "The simulation failed: {}."),
                                           ""};

inline constexpr std::array kRunRows{&kOutOfMemory, &kInternalError};

} // namespace proveout::run_finding
