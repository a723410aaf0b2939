// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of the decimation methods.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::decimation_finding {

inline constexpr FindingRow kMethodMapTooLarge{
    Severity::error,
    false,
    "method-map-too-large",
    PROVEOUT_TEXT("Core", "Map too large for method"),
    PROVEOUT_TEXT("Core", "The method “{}” works on maps of {} points at most; this one has {}."),
    ""};

inline constexpr std::array kDecimationRows{&kMethodMapTooLarge};

} // namespace proveout::decimation_finding
