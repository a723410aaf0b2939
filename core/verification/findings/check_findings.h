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

/// Arguments: id of the finding, owner, reason.
inline constexpr FindingRow kWaiverUnused{
    Severity::note,
    false,
    "waiver-unused",
    PROVEOUT_TEXT("Core", "Waiver without its finding"),
    PROVEOUT_TEXT("Core", "The waiver of {} by {} ({}) has no effect: that finding is gone or has changed."),
    PROVEOUT_TEXT("Core", "Remove the waiver, or look at the finding and waive it again.")};
/// Arguments: id of the finding, owner, reason, tool, its cutter, that of the waiver.
inline constexpr FindingRow kWaiverOfOtherCutter{
    Severity::note,
    false,
    kWaiverUnused.id,
    kWaiverUnused.title,
    PROVEOUT_TEXT("Core", "The waiver of {1} by {2} ({3}) has no effect: T{4} is now “{5}”, it was “{6}”."),
    kWaiverUnused.hint};
/// Arguments: owner, reason.
inline constexpr FindingRow kWaived{
    Severity::note,
    false,
    "waived",
    PROVEOUT_TEXT("Core", "Waived"),
    PROVEOUT_TEXT("Core", "This does not count in the verdict: waived by {} ({})."),
    ""};
inline constexpr FindingRow kRuleSettingUnknown{
    Severity::warning,
    false,
    "rule-setting-unknown",
    PROVEOUT_TEXT("Core", "Unknown rule in the job"),
    PROVEOUT_TEXT("Core", "The job names “{}”, but nothing that is checked has this id."),
    PROVEOUT_TEXT("Core", "Correct the id; “proveout-cli rules” lists all of them.")};

inline constexpr std::array kCheckRows{&kCheckNeedsMemory,   &kCheckOutOfMemory, &kCheckFailed,
                                       &kWaiverUnused,       &kWaived,           &kRuleSettingUnknown,
                                       &kWaiverOfOtherCutter};

} // namespace proveout::check_finding
