// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about what single controls refuse or ignore: grbl, Mach3 and Mach4.
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
    PROVEOUT_TEXT("Core", "{} is not supported by this control."),
    PROVEOUT_TEXT("Core", "The control skips the block, and so does the simulation; remove the code.")};
inline constexpr FindingRow kWordForeign{
    Severity::error,
    true,
    "word-foreign",
    PROVEOUT_TEXT("Core", "Word not supported"),
    PROVEOUT_TEXT("Core", "This control has no word {}."),
    PROVEOUT_TEXT("Core", "The control skips the block, and so does the simulation; remove the word.")};
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
    PROVEOUT_TEXT("Core", "The control reports error:11 and skips the line; split it.")};
inline constexpr FindingRow kBlockNumberLarge{
    Severity::error,
    true,
    "n-large",
    PROVEOUT_TEXT("Core", "Block number too large"),
    PROVEOUT_TEXT("Core", "The block number is larger than {}."),
    PROVEOUT_TEXT("Core", "The control reports error:27 and skips the block; renumber the blocks.")};
inline constexpr FindingRow kSystemCommand{
    Severity::warning,
    true,
    "system-command",
    PROVEOUT_TEXT("Core", "System command"),
    PROVEOUT_TEXT("Core", "{} is a command to the control itself; it is not simulated."),
    PROVEOUT_TEXT("Core",
                  "It may move axes, change settings or clear offsets; send it apart from the program.")};
inline constexpr FindingRow kRealtimeCharacter{
    Severity::warning,
    false,
    "realtime-character",
    PROVEOUT_TEXT("Core", "Real-time command"),
    PROVEOUT_TEXT("Core", "The character {} is a real-time command that acts anywhere, even in comments."),
    PROVEOUT_TEXT("Core", "It may stop the machine or change an override; remove it.")};
inline constexpr FindingRow kRealtimeReset{
    Severity::error,
    true,
    "realtime-reset",
    PROVEOUT_TEXT("Core", "Real-time reset"),
    PROVEOUT_TEXT("Core", "The character {} resets the control or stops it in the middle of the program."),
    PROVEOUT_TEXT("Core", "Remove it.")};
inline constexpr FindingRow kDeleteMarkIgnored{
    Severity::warning,
    false,
    "delete-mark-ignored",
    PROVEOUT_TEXT("Core", "Block delete ignored"),
    PROVEOUT_TEXT("Core", "This control has no block delete: it runs what follows \"/\"."),
    PROVEOUT_TEXT("Core", "Remove the blocks that must not run.")};
inline constexpr FindingRow kPercentRefused{
    Severity::warning,
    false,
    "percent-refused",
    PROVEOUT_TEXT("Core", "\"%\" not supported"),
    PROVEOUT_TEXT("Core", "This control does not know \"%\"."),
    PROVEOUT_TEXT("Core", "The control reports error:1 unless the sender filters the line; remove it.")};
inline constexpr FindingRow kToolNotChanged{
    Severity::warning,
    true,
    "tool-not-changed",
    PROVEOUT_TEXT("Core", "Tool not changed"),
    PROVEOUT_TEXT("Core", "T{} is read, but changes nothing: this control has no tool change."),
    PROVEOUT_TEXT("Core", "Make one program per tool, or change the tool by hand after M0.")};
inline constexpr FindingRow kOptionalStopIgnored{Severity::warning,
                                                 false,
                                                 "optional-stop-ignored",
                                                 PROVEOUT_TEXT("Core", "Optional stop ignored"),
                                                 PROVEOUT_TEXT("Core", "This control does not stop at M1."),
                                                 PROVEOUT_TEXT("Core", "Write M0 where it must stop.")};
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
    PROVEOUT_TEXT("Core", "Write the tool number after H.")};

inline constexpr std::array kForeignRows{
    &kCodeForeign,    &kWordForeign,         &kNoExpressions, &kLineDropped,       &kBlockNumberLarge,
    &kSystemCommand,  &kRealtimeCharacter,   &kRealtimeReset, &kDeleteMarkIgnored, &kPercentRefused,
    &kToolNotChanged, &kOptionalStopIgnored, &kLengthAxis,    &kOWordForeign,      &kLengthNumberMissing};

} // namespace proveout::nc_message
