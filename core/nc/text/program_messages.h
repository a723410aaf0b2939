// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about the file as a whole, its dialect, and the limits of interpretation.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kDialectGuessed{
    Severity::note,
    false,
    "dialect-guessed",
    PROVEOUT_TEXT("Core", "Dialect detected"),
    PROVEOUT_TEXT("Core", "Dialect detected: {} (from {})."),
    PROVEOUT_TEXT("Core", "Choose the dialect yourself if that is wrong.")};
inline constexpr FindingRow kTextBeforePercent{
    Severity::note,
    false,
    "text-before-percent",
    PROVEOUT_TEXT("Core", "Text before \"%\""),
    PROVEOUT_TEXT("Core", "The text before the first \"%\" is not run."),
    ""};
inline constexpr FindingRow kPercentUnpaired{
    Severity::warning,
    false,
    "percent-unpaired",
    PROVEOUT_TEXT("Core", "Opening \"%\" missing"),
    PROVEOUT_TEXT("Core", "The program ends with \"%\" but does not begin with it."),
    PROVEOUT_TEXT("Core", "LinuxCNC refuses this; write \"%\" on the first line too, or on none.")};
inline constexpr FindingRow kPercentInside{
    Severity::error,
    true,
    "percent-inside",
    PROVEOUT_TEXT("Core", "\"%\" inside the program"),
    PROVEOUT_TEXT("Core", "\"%\" is in the middle of the program."),
    PROVEOUT_TEXT("Core", "Controls skip what is before or after it; keep one program per file.")};
inline constexpr FindingRow kAfterPercent{
    Severity::note,
    false,
    "after-percent",
    PROVEOUT_TEXT("Core", "Text after \"%\""),
    PROVEOUT_TEXT("Core", "The text after the second \"%\" is not run."),
    ""};
inline constexpr FindingRow kAfterEnd{Severity::note,
                                      false,
                                      "after-program-end",
                                      PROVEOUT_TEXT("Core", "Blocks after program end"),
                                      PROVEOUT_TEXT("Core", "The blocks after the program end are not run."),
                                      ""};
inline constexpr FindingRow kNoProgramEnd{
    Severity::warning,
    false,
    "no-program-end",
    PROVEOUT_TEXT("Core", "Program end missing"),
    PROVEOUT_TEXT("Core", "The program has no end: M2, M30 or a pair of \"%\"."),
    PROVEOUT_TEXT("Core", "Add M30 as the last block.")};
inline constexpr FindingRow kNoMotion{
    Severity::warning,
    true,
    "no-motion",
    PROVEOUT_TEXT("Core", "No motion"),
    PROVEOUT_TEXT("Core", "The program has no motion."),
    PROVEOUT_TEXT("Core", "Check that this is the right file and that it is complete.")};
inline constexpr FindingRow kTooManyMotions{
    Severity::error,
    true,
    "too-many-motions",
    PROVEOUT_TEXT("Core", "Too many motions"),
    PROVEOUT_TEXT("Core", "The program has more than {} motions; interpretation ends here."),
    PROVEOUT_TEXT("Core", "Raise the limit, or split the program.")};
inline constexpr FindingRow kProgramTooLarge{
    Severity::error,
    true,
    "program-too-large",
    PROVEOUT_TEXT("Core", "Program too large"),
    PROVEOUT_TEXT("Core",
                  "The motions of the program need more than {} of memory; interpretation ends here."),
    PROVEOUT_TEXT("Core", "Close other programs, or split the program.")};
inline constexpr FindingRow kTooManyEvents{
    Severity::error,
    true,
    "too-many-events",
    PROVEOUT_TEXT("Core", "Too many events"),
    PROVEOUT_TEXT("Core", "The program has more than {} tool changes, stops, dwells and the like; "
                          "interpretation ends here."),
    PROVEOUT_TEXT("Core", "Raise the limit, or split the program.")};
inline constexpr FindingRow kStopped{
    Severity::warning,
    true,
    "interpretation-stopped",
    PROVEOUT_TEXT("Core", "Interpretation stopped"),
    PROVEOUT_TEXT("Core", "Interpretation was stopped before this line; the last one was {}."),
    ""};
inline constexpr FindingRow kStillReading{
    Severity::note,
    true,
    "still-reading",
    PROVEOUT_TEXT("Core", "Still reading"),
    PROVEOUT_TEXT("Core", "The program is still being read; the lines from here on are missing."),
    ""};

inline constexpr std::array kProgramRows{
    &kDialectGuessed, &kTextBeforePercent, &kPercentUnpaired, &kPercentInside,  &kAfterPercent,
    &kAfterEnd,       &kNoProgramEnd,      &kNoMotion,        &kTooManyMotions, &kProgramTooLarge,
    &kTooManyEvents,  &kStopped,           &kStillReading};

} // namespace proveout::nc_message
