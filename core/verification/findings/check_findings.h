// SPDX-License-Identifier: GPL-3.0-or-later
// Why a program is not checked.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::check_finding {

inline constexpr FindingRow kCheckNeedsMemory{
    Severity::error,
    false,
    "check-needs-memory",
    PROVEOUT_TEXT("Core", "Not checked: not enough memory"),
    PROVEOUT_TEXT("Core", "The program is not checked: that needs {}, but only {} are available."),
    PROVEOUT_TEXT("Core", "Choose a coarser grid, or close other programs.")};

inline constexpr FindingRow kCheckOutOfMemory{
    Severity::error,
    false,
    "out-of-memory",
    PROVEOUT_TEXT("Core", "Out of memory"),
    PROVEOUT_TEXT("Core", "There is not enough memory to check the program."),
    PROVEOUT_TEXT("Core", "Choose a coarser grid, or close other programs.")};
inline constexpr FindingRow kCheckFailed{Severity::error,
                                         false,
                                         "internal-error",
                                         PROVEOUT_TEXT("Core", "Internal error"),
                                         PROVEOUT_TEXT("Core", "The check failed: {}."),
                                         ""};

inline constexpr std::array kCheckRows{&kCheckNeedsMemory, &kCheckOutOfMemory, &kCheckFailed};

} // namespace proveout::check_finding
