// SPDX-License-Identifier: GPL-3.0-or-later
// System variables that only Haas's controls have. Source: Haas's mill operator's manual, macro system
// variables.
#pragma once

#include <optional>

namespace proveout {

/// Timers, counters, loads and monitors, which are 0 on a new machine: a program reads them to count or to
/// warn, not to position.
[[nodiscard]] bool isMonitorOfHaas(int number);

/// Inputs, settings and parameters, whose value only the machine knows.
[[nodiscard]] bool isSettingOfHaas(int number);

/// The other number of a general-purpose variable: #10100 is #100. Nothing if it has only one number.
[[nodiscard]] std::optional<int> legacyNumberOfHaas(int number);

} // namespace proveout
