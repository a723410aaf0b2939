// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about the detail region, the finer grid in a box of the stock.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::detail_finding {

inline constexpr FindingRow kBoxNeedsTooMuchMemory{
    Severity::error,
    false,
    "box-needs-too-much-memory",
    PROVEOUT_TEXT("Core", "Box needs too much memory"),
    PROVEOUT_TEXT(
        "Core",
        "A detail region of {} × {} points needs {}; {} is available, enough for a spacing of {} mm."),
    ""};

inline constexpr std::array kDetailRows{&kBoxNeedsTooMuchMemory};

} // namespace proveout::detail_finding
