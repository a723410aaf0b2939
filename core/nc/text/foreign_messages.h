// SPDX-License-Identifier: GPL-3.0-or-later
// What single controls refuse or ignore: grbl, Mach3 and Mach4.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kCodeForeign{
    Severity::error,
    true,
    "code-foreign",
    PROVEOUT_TEXT("Core", "Code not supported"),
    PROVEOUT_TEXT("Core", "{} is no order of this control."),
    PROVEOUT_TEXT("Core", "The control drops the block, and so does the simulation; take the code out.")};
inline constexpr FindingRow kWordForeign{
    Severity::error,
    true,
    "word-foreign",
    PROVEOUT_TEXT("Core", "Word not supported"),
    PROVEOUT_TEXT("Core", "This control has no word {}."),
    PROVEOUT_TEXT("Core", "The control drops the block, and so does the simulation; take the word out.")};
inline constexpr FindingRow kNoExpressions{
    Severity::error,
    true,
    "no-expressions",
    PROVEOUT_TEXT("Core", "Expressions not supported"),
    PROVEOUT_TEXT("Core", "This control has neither parameters nor expressions."),
    PROVEOUT_TEXT("Core", "Let the CAM system write plain numbers.")};
inline constexpr FindingRow kLineDropped{
    Severity::error,
    true,
    "line-dropped",
    PROVEOUT_TEXT("Core", "Line dropped"),
    PROVEOUT_TEXT(
        "Core", "The line has {} characters without blanks and comments; the control reads no more than {}."),
    PROVEOUT_TEXT("Core", "The control answers error:11 and drops the line; split it.")};
inline constexpr FindingRow kBlockNumberLarge{
    Severity::error,
    true,
    "n-large",
    PROVEOUT_TEXT("Core", "Block number too large"),
    PROVEOUT_TEXT("Core", "The block number is larger than {}."),
    PROVEOUT_TEXT("Core", "The control answers error:27 and drops the block; number the blocks anew.")};
inline constexpr FindingRow kSystemCommand{
    Severity::warning,
    true,
    "system-command",
    PROVEOUT_TEXT("Core", "System command"),
    PROVEOUT_TEXT("Core", "{} is an order to the control itself; it is not carried out here."),
    PROVEOUT_TEXT("Core",
                  "It may move axes, change settings or clear offsets; send it apart from the program.")};
inline constexpr FindingRow kRealtimeCharacter{
    Severity::warning,
    false,
    "realtime-character",
    PROVEOUT_TEXT("Core", "Real-time command"),
    PROVEOUT_TEXT(
        "Core",
        "The character {} is an order to the control that counts wherever it stands, also in comments."),
    PROVEOUT_TEXT("Core", "It may stop the machine or change an override; take it out.")};
inline constexpr FindingRow kRealtimeReset{
    Severity::error,
    true,
    "realtime-reset",
    PROVEOUT_TEXT("Core", "Real-time reset"),
    PROVEOUT_TEXT("Core", "The character {} resets the control or stops it in the middle of the program."),
    PROVEOUT_TEXT("Core", "Take it out.")};
inline constexpr FindingRow kDeleteMarkIgnored{
    Severity::warning,
    false,
    "delete-mark-ignored",
    PROVEOUT_TEXT("Core", "Block delete ignored"),
    PROVEOUT_TEXT("Core", "This control has no block delete: it runs what stands behind \"/\"."),
    PROVEOUT_TEXT("Core", "Take the blocks out that are not to run.")};
inline constexpr FindingRow kPercentRefused{
    Severity::warning,
    false,
    "percent-refused",
    PROVEOUT_TEXT("Core", "\"%\" not supported"),
    PROVEOUT_TEXT("Core", "This control does not know \"%\"."),
    PROVEOUT_TEXT("Core", "The control answers error:1 unless the sender keeps the line back; remove it.")};
inline constexpr FindingRow kToolNotChanged{
    Severity::warning,
    true,
    "tool-not-changed",
    PROVEOUT_TEXT("Core", "Tool not changed"),
    PROVEOUT_TEXT("Core", "T{} is read, but changes nothing: this control has no tool change."),
    PROVEOUT_TEXT("Core", "Make one program for each tool, or change it by hand behind M0.")};
inline constexpr FindingRow kOptionalStopIgnored{Severity::warning,
                                                 false,
                                                 "optional-stop-ignored",
                                                 PROVEOUT_TEXT("Core", "Optional stop ignored"),
                                                 PROVEOUT_TEXT("Core", "This control does not stop at M1."),
                                                 PROVEOUT_TEXT("Core", "Write M0 where it has to stop.")};
inline constexpr FindingRow kLengthAxis{
    Severity::error,
    true,
    "length-axis",
    PROVEOUT_TEXT("Core", "Length offset axis"),
    PROVEOUT_TEXT("Core", "G43.1 takes the word Z and no other axis on this control."),
    PROVEOUT_TEXT("Core", "Write G43.1 Z… in a block of its own.")};
inline constexpr FindingRow kOWordForeign{
    Severity::error,
    true,
    "o-word-foreign",
    PROVEOUT_TEXT("Core", "O word not supported"),
    PROVEOUT_TEXT("Core", "This control knows O with a number alone, as the beginning of a subprogram."),
    PROVEOUT_TEXT("Core", "Call it with M98 and end it with M99.")};
inline constexpr FindingRow kLengthNumberMissing{
    Severity::warning,
    true,
    "length-number-missing",
    PROVEOUT_TEXT("Core", "Length offset number missing"),
    PROVEOUT_TEXT("Core", "{} without H, or with H0, sets the tool length offset to 0."),
    PROVEOUT_TEXT("Core", "Write the number of the tool behind H.")};

inline constexpr std::array kForeignRows{
    &kCodeForeign,    &kWordForeign,         &kNoExpressions, &kLineDropped,       &kBlockNumberLarge,
    &kSystemCommand,  &kRealtimeCharacter,   &kRealtimeReset, &kDeleteMarkIgnored, &kPercentRefused,
    &kToolNotChanged, &kOptionalStopIgnored, &kLengthAxis,    &kOWordForeign,      &kLengthNumberMissing};

} // namespace proveout::nc_message
