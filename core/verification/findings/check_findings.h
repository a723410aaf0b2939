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

inline constexpr std::array kCheckRows{&kCheckNeedsMemory};

} // namespace proveout::check_finding
