// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about codes and the words of a block.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kUnknownCode{Severity::error,
                                         true,
                                         "code-unknown",
                                         PROVEOUT_TEXT("Core", "Unknown code"),
                                         PROVEOUT_TEXT("Core", "{} is not a known code."),
                                         PROVEOUT_TEXT("Core", "Results after this block are unverified.")};
inline constexpr FindingRow kUnknownMCode{
    Severity::error,
    true,
    "code-unknown",
    PROVEOUT_TEXT("Core", "Unknown code"),
    PROVEOUT_TEXT("Core", "{} is not a known code."),
    PROVEOUT_TEXT("Core", "If it moves no axis (a clamp, a door, air), add it to the ignored M codes of the "
                          "setup; until then, results after this block are unverified.")};
inline constexpr FindingRow kCodeIgnored{
    Severity::note,
    false,
    "code-ignored",
    PROVEOUT_TEXT("Core", "Code ignored"),
    PROVEOUT_TEXT("Core", "{} ({}) moves no axis and is ignored ({}×, line {})."),
    PROVEOUT_TEXT("Core", "The machine builder defines M codes; check this one where it matters.")};
inline constexpr FindingRow kCodeIgnoredByList{
    Severity::note,
    false,
    "code-ignored",
    PROVEOUT_TEXT("Core", "Code ignored"),
    PROVEOUT_TEXT("Core", "{} is ignored because the setup lists it ({}×, line {})."),
    PROVEOUT_TEXT("Core", "Remove it from the ignored M codes if it moves an axis.")};
inline constexpr FindingRow kCodeIgnoredInLines{
    Severity::note,
    false,
    kCodeIgnored.id,
    kCodeIgnored.title,
    PROVEOUT_TEXT("Core", "{} ({}) moves no axis and is ignored ({}×, lines {})."),
    kCodeIgnored.hint};
inline constexpr FindingRow kCodeIgnoredByListInLines{
    Severity::note,
    false,
    kCodeIgnoredByList.id,
    kCodeIgnoredByList.title,
    PROVEOUT_TEXT("Core", "{} is ignored because the setup lists it ({}×, lines {})."),
    kCodeIgnoredByList.hint};
inline constexpr FindingRow kIgnoredExecuted{
    Severity::warning,
    false,
    "ignored-code-executed",
    PROVEOUT_TEXT("Core", "Listed code executed"),
    PROVEOUT_TEXT("Core", "{} ({}) is executed although the setup lists it as ignored."),
    PROVEOUT_TEXT("Core", "Remove it from the ignored M codes: only codes without a known effect can be "
                          "ignored.")};
inline constexpr FindingRow kUnsupportedCode{
    Severity::error,
    true,
    "code-unsupported",
    PROVEOUT_TEXT("Core", "Unsupported code"),
    PROVEOUT_TEXT("Core", "{} ({}) is not supported yet."),
    PROVEOUT_TEXT("Core", "Results after this block are unverified.")};
inline constexpr FindingRow kModalConflict{
    Severity::error,
    true,
    "modal-conflict",
    PROVEOUT_TEXT("Core", "Conflicting codes"),
    PROVEOUT_TEXT("Core", "{} and {} cannot be used in one block."),
    PROVEOUT_TEXT("Core", "Keep one of them, or make two blocks; this block is skipped.")};
inline constexpr FindingRow kLastCounts{
    Severity::warning,
    false,
    "last-counts",
    PROVEOUT_TEXT("Core", "Conflicting codes, last used"),
    PROVEOUT_TEXT("Core", "{} and {} cannot be used in one block; the last one counts."),
    PROVEOUT_TEXT("Core", "Some controls give an alarm instead; keep one of them.")};
inline constexpr FindingRow kTooManyM{
    Severity::error,
    true,
    "too-many-m",
    PROVEOUT_TEXT("Core", "Too many M codes"),
    PROVEOUT_TEXT("Core", "The block has more than {} M words."),
    PROVEOUT_TEXT("Core", "Make several blocks of it; this block is skipped.")};
inline constexpr FindingRow kAxisUnsupported{Severity::error,
                                             true,
                                             "axis-unsupported",
                                             PROVEOUT_TEXT("Core", "Axis ignored"),
                                             PROVEOUT_TEXT("Core", "{} axis ignored (three-axis machine)."),
                                             PROVEOUT_TEXT("Core", "The motion is shown without it.")};
inline constexpr FindingRow kWordUnused{
    Severity::error,
    true,
    "word-unused",
    PROVEOUT_TEXT("Core", "Unused word"),
    PROVEOUT_TEXT("Core", "No code of this block uses the word {}."),
    PROVEOUT_TEXT("Core", "Remove it, or add the code that it belongs to; this block is skipped.")};
inline constexpr FindingRow kWordIgnored{
    Severity::warning,
    true,
    "word-ignored",
    PROVEOUT_TEXT("Core", "Word ignored"),
    PROVEOUT_TEXT("Core", "No code of this block uses the word {}; it is ignored."),
    PROVEOUT_TEXT("Core", "Remove it, or add the code that it belongs to.")};
inline constexpr FindingRow kSpindleNumber{
    Severity::error,
    true,
    "spindle-number",
    PROVEOUT_TEXT("Core", "No such spindle"),
    PROVEOUT_TEXT("Core", "There is no spindle {}: the machine has one, $0."),
    PROVEOUT_TEXT("Core", "Write $0, or leave the word out; this block is skipped.")};
inline constexpr FindingRow kAxisWithoutMotion{
    Severity::error,
    true,
    "axis-without-motion",
    PROVEOUT_TEXT("Core", "No motion code active"),
    PROVEOUT_TEXT("Core", "No motion code is active for the word {}."),
    PROVEOUT_TEXT("Core", "Write G0, G1, G2 or G3 into the block; this block is skipped.")};
inline constexpr FindingRow kG80WithAxis{
    Severity::error,
    true,
    "g80-with-axis",
    PROVEOUT_TEXT("Core", "Axis word with G80"),
    PROVEOUT_TEXT("Core", "G80 cannot move the axis {}."),
    PROVEOUT_TEXT("Core", "Controls differ here; move in a block of its own. This block is skipped.")};
inline constexpr FindingRow kRapidAfterG80{
    Severity::warning,
    false,
    "rapid-after-g80",
    PROVEOUT_TEXT("Core", "Rapid after G80"),
    PROVEOUT_TEXT("Core", "After G80, {} moves without a motion code, at rapid."),
    PROVEOUT_TEXT("Core", "Write G0 or G1 into the block; controls differ here.")};
inline constexpr FindingRow kWordMissing{Severity::error,
                                         true,
                                         "word-missing",
                                         PROVEOUT_TEXT("Core", "Word missing"),
                                         PROVEOUT_TEXT("Core", "{} needs the word {}."),
                                         PROVEOUT_TEXT("Core", "Add it; the code has no effect without it.")};
inline constexpr FindingRow kNegative{Severity::error,
                                      true,
                                      "number-negative",
                                      PROVEOUT_TEXT("Core", "Negative number"),
                                      PROVEOUT_TEXT("Core", "The value of {} must not be negative."),
                                      PROVEOUT_TEXT("Core", "The word is ignored.")};
inline constexpr FindingRow kNotInteger{
    Severity::error,
    true,
    "number-not-integer",
    PROVEOUT_TEXT("Core", "Not a whole number"),
    PROVEOUT_TEXT("Core", "The value of {} must be a whole number from {} to {}."),
    PROVEOUT_TEXT("Core", "The word is ignored.")};
inline constexpr FindingRow kAxesTwice{
    Severity::error,
    true,
    "axes-used-twice",
    PROVEOUT_TEXT("Core", "Axis words used twice"),
    PROVEOUT_TEXT("Core", "{} and {} both use the axis words of this block."),
    PROVEOUT_TEXT("Core", "Make two blocks; this block is skipped.")};
inline constexpr FindingRow kNothingSaved{
    Severity::error,
    true,
    "modal-state-not-saved",
    PROVEOUT_TEXT("Core", "No modal state saved"),
    PROVEOUT_TEXT("Core", "M72 restores a modal state, but none is saved at this level of calls."),
    PROVEOUT_TEXT("Core", "Write M70 or M73 before it, in the same subprogram.")};
inline constexpr FindingRow kRestoreNotAlone{
    Severity::warning,
    true,
    "modal-restore-not-alone",
    PROVEOUT_TEXT("Core", "M72 not alone"),
    PROVEOUT_TEXT("Core", "M72 is not alone in its block."),
    PROVEOUT_TEXT("Core",
                  "LinuxCNC ignores the rest of the block after restoring; give M72 a block of its own.")};
inline constexpr FindingRow kNoToolSelected{
    Severity::error,
    true,
    "tool-not-selected",
    PROVEOUT_TEXT("Core", "No tool selected"),
    PROVEOUT_TEXT("Core", "M6 changes the tool, but none is selected."),
    PROVEOUT_TEXT("Core", "Write the T word into the block or before it.")};

inline constexpr std::array kCodeRows{&kUnknownCode,       &kUnknownMCode,       &kCodeIgnored,
                                      &kCodeIgnoredByList, &kCodeIgnoredInLines, &kCodeIgnoredByListInLines,
                                      &kIgnoredExecuted,   &kUnsupportedCode,    &kModalConflict,
                                      &kLastCounts,        &kTooManyM,           &kAxisUnsupported,
                                      &kWordUnused,        &kWordIgnored,        &kSpindleNumber,
                                      &kAxisWithoutMotion, &kG80WithAxis,        &kRapidAfterG80,
                                      &kWordMissing,       &kNegative,           &kNotInteger,
                                      &kAxesTwice,         &kNothingSaved,       &kRestoreNotAlone,
                                      &kNoToolSelected};

} // namespace proveout::nc_message
