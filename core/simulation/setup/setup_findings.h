// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about the setup: its parameters, its machine, and the position of its stock.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::setup_finding {

inline constexpr FindingRow kMachineValue{
    Severity::error,
    false,
    "machine-value",
    PROVEOUT_TEXT("Core", "Invalid machine value"),
    PROVEOUT_TEXT("Core", "\"{}\" of the machine must be a number from {} to {}."),
    ""};
inline constexpr FindingRow kMachineKey{Severity::error,
                                        false,
                                        "machine-key",
                                        PROVEOUT_TEXT("Core", "Unknown machine key"),
                                        PROVEOUT_TEXT("Core", "A machine has no \"{}\"; it has {}."),
                                        ""};
inline constexpr FindingRow kMachineProfile{
    Severity::error,
    false,
    "machine-profile",
    PROVEOUT_TEXT("Core", "Unknown machine profile"),
    PROVEOUT_TEXT("Core", "The machine profile \"{}\" is unknown; the profiles are {}."),
    PROVEOUT_TEXT("Core", "Begin with a profile, or write values only, as in rapidXY=20000.")};
inline constexpr FindingRow kParameterOutOfRange{
    Severity::error,
    false,
    "parameter-out-of-range",
    PROVEOUT_TEXT("Core", "Parameter out of range"),
    PROVEOUT_TEXT("Core", "The parameter \"{}\" is {}; it must be in {} … {}."),
    ""};
inline constexpr FindingRow kNeverCuts{
    Severity::warning,
    false,
    "never-cuts",
    PROVEOUT_TEXT("Core", "Program never cuts"),
    PROVEOUT_TEXT("Core",
                  "The program never cuts the stock: its cutting moves are within {}, the stock within {}."),
    PROVEOUT_TEXT("Core", "Check the size and position of the stock, and the work offset: the position of "
                          "the stock is that of its top, not its bottom.")};
inline constexpr FindingRow kStockMissed{
    Severity::warning,
    false,
    "stock-missed",
    PROVEOUT_TEXT("Core", "Stock missed"),
    PROVEOUT_TEXT("Core", "Cutting moves extend {} mm beyond the stock in {}, where it measures {} mm."),
    kNeverCuts.hint};
inline constexpr FindingRow kGridCoarseAutomatic{
    Severity::warning,
    false,
    "grid-coarse",
    PROVEOUT_TEXT("Core", "Grid coarse"),
    PROVEOUT_TEXT(
        "Core", "The grid spacing of {} mm is too coarse for T{} (⌀{} mm): it has only {} points across it."),
    PROVEOUT_TEXT("Core",
                  "See details with View, Magnifier, or in a smaller stock, or enter a finer grid spacing.")};
inline constexpr FindingRow kGridCoarse{
    Severity::warning,
    false,
    "grid-coarse",
    PROVEOUT_TEXT("Core", "Grid coarse"),
    PROVEOUT_TEXT(
        "Core", "The grid spacing of {} mm is too coarse for T{} (⌀{} mm): it has only {} points across it."),
    PROVEOUT_TEXT("Core", "Choose a finer grid, or the automatic one; see details with View, Magnifier, or "
                          "in a smaller stock.")};

inline constexpr std::array kSetupRows{&kMachineValue, &kMachineKey,    &kParameterOutOfRange,
                                       &kNeverCuts,    &kStockMissed,   &kGridCoarseAutomatic,
                                       &kGridCoarse,   &kMachineProfile};

} // namespace proveout::setup_finding
