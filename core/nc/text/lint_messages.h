// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about what is allowed but seldom intended; the table of the rules is in core/nc/run/lint.cpp.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kFeedZero{Severity::warning,
                                      false,
                                      "feed-zero",
                                      PROVEOUT_TEXT("Core", "Feed rate 0"),
                                      PROVEOUT_TEXT("Core", "The feed rate is 0."),
                                      PROVEOUT_TEXT("Core", "Give F a value above 0.")};
inline constexpr FindingRow kLengthMissing{
    Severity::warning,
    false,
    "length-missing",
    PROVEOUT_TEXT("Core", "Tool length offset missing"),
    PROVEOUT_TEXT("Core", "T{} cuts without its own tool length offset."),
    PROVEOUT_TEXT("Core",
                  "Write G43 after the tool change: the offset of the previous tool is still active.")};
inline constexpr FindingRow kOffsetNeverChosen{
    Severity::note,
    false,
    "offset-never-chosen",
    PROVEOUT_TEXT("Core", "Work offset not selected"),
    PROVEOUT_TEXT("Core", "The program cuts before it selects a work offset."),
    PROVEOUT_TEXT("Core", "Write G54, or the work offset of the part.")};
inline constexpr FindingRow kLengthOfOtherTool{
    Severity::warning,
    false,
    "length-of-other-tool",
    PROVEOUT_TEXT("Core", "Length offset mismatch"),
    PROVEOUT_TEXT("Core", "The tool length offset H{} does not match tool {}."),
    PROVEOUT_TEXT("Core", "Use the tool number, unless another offset is intended.")};
inline constexpr FindingRow kDiameterMissing{
    Severity::warning,
    false,
    "diameter-missing",
    PROVEOUT_TEXT("Core", "D word missing"),
    PROVEOUT_TEXT("Core", "{} has no D word."),
    PROVEOUT_TEXT("Core", "Write the offset number: the last one used is active.")};
inline constexpr FindingRow kCompensationOnArc{
    Severity::warning,
    false,
    "compensation-on-arc",
    PROVEOUT_TEXT("Core", "Compensation start-up on arc"),
    PROVEOUT_TEXT("Core", "Cutter compensation begins on an arc."),
    PROVEOUT_TEXT("Core", "Lead in with a straight motion; many controls give an alarm here.")};
inline constexpr FindingRow kUnitsMixed{
    Severity::warning,
    false,
    "units-mixed",
    PROVEOUT_TEXT("Core", "Mixed units"),
    PROVEOUT_TEXT("Core", "{} changes the unit in the middle of the program."),
    PROVEOUT_TEXT("Core", "Keep to one unit; active lengths keep the old one.")};
inline constexpr FindingRow kLeftOn{
    Severity::warning,
    false,
    "left-on",
    PROVEOUT_TEXT("Core", "Modal function left on"),
    PROVEOUT_TEXT("Core", "Still active here: {}."),
    PROVEOUT_TEXT("Core", "End it before the tool change and before the end of the program.")};
inline constexpr FindingRow kChangeLow{
    Severity::warning,
    false,
    "change-low",
    PROVEOUT_TEXT("Core", "Tool change too low"),
    PROVEOUT_TEXT("Core", "The tool is changed at Z{}, not above Z{}, where it cut."),
    PROVEOUT_TEXT("Core", "Retract first.")};
inline constexpr FindingRow kChangeTurning{
    Severity::note,
    false,
    "change-turning",
    PROVEOUT_TEXT("Core", "Tool change, spindle running"),
    PROVEOUT_TEXT("Core", "The tool is changed while the spindle turns."),
    PROVEOUT_TEXT("Core", "Write M5 before it; not every machine stops the spindle by itself.")};
inline constexpr FindingRow kUnreachable{
    Severity::warning,
    false,
    "unreachable",
    PROVEOUT_TEXT("Core", "Unreachable block"),
    PROVEOUT_TEXT("Core", "This block is unreachable: line {} always jumps past it."),
    PROVEOUT_TEXT("Core", "Remove it, or give it the block number or label of a jump.")};
inline constexpr FindingRow kToolNotInTable{
    Severity::warning,
    false,
    "tool-not-in-table",
    PROVEOUT_TEXT("Core", "Tool not in table"),
    PROVEOUT_TEXT("Core", "T{} is selected, but the tool table does not have it."),
    PROVEOUT_TEXT("Core", "Add the tool, or correct the number.")};
inline constexpr FindingRow kNearlyHalfCircle{
    Severity::warning,
    false,
    "nearly-half-circle",
    PROVEOUT_TEXT("Core", "Nearly a half circle"),
    PROVEOUT_TEXT("Core", "The arc by its radius is nearly a half circle, {} degrees."),
    PROVEOUT_TEXT("Core", "Program the centre with I, J and K: here the last digit of R moves it far.")};

inline constexpr std::array kLintRows{&kFeedZero,          &kLengthMissing,   &kOffsetNeverChosen,
                                      &kLengthOfOtherTool, &kDiameterMissing, &kCompensationOnArc,
                                      &kUnitsMixed,        &kLeftOn,          &kChangeLow,
                                      &kChangeTurning,     &kUnreachable,     &kToolNotInTable,
                                      &kNearlyHalfCircle};

} // namespace proveout::nc_message
