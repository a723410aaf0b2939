// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about conditions of breakpoints.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::condition_finding {

inline constexpr FindingRow kConditionTooLong{Severity::error,
                                              false,
                                              "condition-too-long",
                                              PROVEOUT_TEXT("Core", "Condition too long"),
                                              PROVEOUT_TEXT("Core", "A condition has {} characters at most."),
                                              ""};
inline constexpr FindingRow kConditionOperand{
    Severity::error,
    false,
    "condition",
    PROVEOUT_TEXT("Core", "Invalid condition"),
    PROVEOUT_TEXT("Core", "Column {}: a number or one of the letters X Y Z F S T N L is expected here."),
    ""};
inline constexpr FindingRow kConditionComparison{
    Severity::error,
    false,
    "condition",
    PROVEOUT_TEXT("Core", "Invalid condition"),
    PROVEOUT_TEXT("Core", "Column {}: one of < <= > >= == != is expected here."),
    ""};
inline constexpr FindingRow kConditionJoin{Severity::error,
                                           false,
                                           "condition",
                                           PROVEOUT_TEXT("Core", "Invalid condition"),
                                           PROVEOUT_TEXT("Core", "Column {}: && or || is expected here."),
                                           ""};
inline constexpr FindingRow kConditionParenthesis{
    Severity::error,
    false,
    "condition",
    PROVEOUT_TEXT("Core", "Invalid condition"),
    PROVEOUT_TEXT("Core", "Column {}: a closing parenthesis is expected here."),
    ""};
inline constexpr FindingRow kConditionDepth{
    Severity::error,
    false,
    "condition",
    PROVEOUT_TEXT("Core", "Invalid condition"),
    PROVEOUT_TEXT("Core", "Column {}: the parentheses are nested too deeply."),
    ""};

inline constexpr std::array kConditionRows{&kConditionTooLong, &kConditionOperand,     &kConditionComparison,
                                           &kConditionJoin,    &kConditionParenthesis, &kConditionDepth};

} // namespace proveout::condition_finding
