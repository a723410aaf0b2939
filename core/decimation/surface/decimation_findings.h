// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of the decimation methods and of their memory.
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
inline constexpr FindingRow kSurfaceTooLarge{
    Severity::warning,
    false,
    "surface-too-large",
    PROVEOUT_TEXT("Core", "Surface too large"),
    PROVEOUT_TEXT("Core", "The surface needs more than the {} of memory that are available, and is drawn "
                          "without decimation; any surface on a grid of {} mm would fit."),
    PROVEOUT_TEXT("Core", "Choose a coarser grid or a larger allowance.")};

inline constexpr std::array kDecimationRows{&kMethodMapTooLarge, &kSurfaceTooLarge};

} // namespace proveout::decimation_finding
