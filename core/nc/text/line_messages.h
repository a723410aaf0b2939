// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about lines that cannot be read: characters, words, comments, block numbers, "%".
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kBadCharacter{
    Severity::error,
    true,
    "bad-character",
    PROVEOUT_TEXT("Core", "Unexpected character"),
    PROVEOUT_TEXT("Core", "\"{}\" has no meaning here."),
    PROVEOUT_TEXT("Core", "Remove the character, or put the text into a comment: ( … ).")};
inline constexpr FindingRow kNumberMissing{
    Severity::error,
    true,
    "number-missing",
    PROVEOUT_TEXT("Core", "Word without a value"),
    PROVEOUT_TEXT("Core", "{} word without a value."),
    PROVEOUT_TEXT("Core", "Write the value after the letter, for example X10.5.")};
inline constexpr FindingRow kDoubleSign{
    Severity::error,
    true,
    "number-double-sign",
    PROVEOUT_TEXT("Core", "Number with two signs"),
    PROVEOUT_TEXT("Core", "The value of {} has two signs."),
    PROVEOUT_TEXT("Core", "Controls read this differently; write one sign.")};
inline constexpr FindingRow kTwoPoints{Severity::error,
                                       true,
                                       "number-two-points",
                                       PROVEOUT_TEXT("Core", "Number with two points"),
                                       PROVEOUT_TEXT("Core", "The value of {} has two decimal points."),
                                       PROVEOUT_TEXT("Core", "Keep one point.")};
inline constexpr FindingRow kNumberOutOfRange{
    Severity::error,
    true,
    "number-out-of-range",
    PROVEOUT_TEXT("Core", "Number out of range"),
    PROVEOUT_TEXT("Core", "The value of {} is out of range: larger than 1e12."),
    PROVEOUT_TEXT("Core", "Check the number.")};
inline constexpr FindingRow kCommentUnclosed{Severity::error,
                                             true,
                                             "comment-unclosed",
                                             PROVEOUT_TEXT("Core", "Comment not closed"),
                                             PROVEOUT_TEXT("Core", "The comment is not closed."),
                                             PROVEOUT_TEXT("Core", "Close it with \")\" in the same line.")};
inline constexpr FindingRow kCommentNested{
    Severity::error,
    true,
    "comment-nested",
    PROVEOUT_TEXT("Core", "Nested comment"),
    PROVEOUT_TEXT("Core", "A comment is nested in a comment."),
    PROVEOUT_TEXT("Core", "Controls end it at different brackets; use no \"(\" within a comment.")};
inline constexpr FindingRow kWordTwice{Severity::error,
                                       true,
                                       "word-twice",
                                       PROVEOUT_TEXT("Core", "Duplicate word"),
                                       PROVEOUT_TEXT("Core", "Duplicate {} word."),
                                       PROVEOUT_TEXT("Core", "Keep one of them, or make two blocks.")};
inline constexpr FindingRow kLastWordCounts{
    Severity::warning,
    false,
    "last-word-counts",
    PROVEOUT_TEXT("Core", "Duplicate word, last used"),
    PROVEOUT_TEXT("Core", "Duplicate {} word; the last one counts."),
    PROVEOUT_TEXT("Core", "Some controls give an alarm instead; keep one of them.")};
inline constexpr FindingRow kTooManyCodes{Severity::error,
                                          true,
                                          "too-many-codes",
                                          PROVEOUT_TEXT("Core", "Too many codes in block"),
                                          PROVEOUT_TEXT("Core", "The block has more than 24 G and M words."),
                                          PROVEOUT_TEXT("Core", "Make several blocks of it.")};
inline constexpr FindingRow kBlockNumberPlace{
    Severity::error,
    true,
    "n-not-first",
    PROVEOUT_TEXT("Core", "N word not first"),
    PROVEOUT_TEXT("Core", "The N word does not begin the block."),
    PROVEOUT_TEXT("Core", "Write it first, or put it on a line of its own.")};
inline constexpr FindingRow kBlockNumberNegative{Severity::error,
                                                 true,
                                                 "n-negative",
                                                 PROVEOUT_TEXT("Core", "Negative block number"),
                                                 PROVEOUT_TEXT("Core", "The block number is negative."),
                                                 PROVEOUT_TEXT("Core", "Use N with digits only.")};
inline constexpr FindingRow kBlockNumberLong{
    Severity::warning,
    false,
    "n-long",
    PROVEOUT_TEXT("Core", "Block number too long"),
    PROVEOUT_TEXT("Core", "The block number has more than 15 digits, which controls cannot hold."),
    PROVEOUT_TEXT("Core", "It is a label only; renumber the blocks.")};
inline constexpr FindingRow kPercentNotAlone{
    Severity::error,
    true,
    "percent-not-alone",
    PROVEOUT_TEXT("Core", "\"%\" not alone"),
    PROVEOUT_TEXT("Core", "\"%\" marks the beginning and the end of a tape and must be alone on its line."),
    PROVEOUT_TEXT("Core", "Move the rest to another line.")};
inline constexpr FindingRow kLineLong{
    Severity::warning,
    false,
    "line-long",
    PROVEOUT_TEXT("Core", "Line too long"),
    PROVEOUT_TEXT("Core", "The line has {} characters; LinuxCNC refuses more than 252."),
    PROVEOUT_TEXT("Core", "Split the line.")};
inline constexpr FindingRow kControlCode{
    Severity::warning,
    false,
    "control-code",
    PROVEOUT_TEXT("Core", "Control codes skipped"),
    PROVEOUT_TEXT("Core", "Control codes of a tape or a serial line were skipped."),
    PROVEOUT_TEXT("Core", "Harmless here; save the file as plain text to remove them.")};
inline constexpr FindingRow kByteOrderMark{
    Severity::warning,
    false,
    "byte-order-mark",
    PROVEOUT_TEXT("Core", "Byte order mark"),
    PROVEOUT_TEXT("Core", "The file begins with a byte order mark, which controls reject."),
    PROVEOUT_TEXT("Core", "Save it as UTF-8 without the mark, or as ASCII.")};
inline constexpr FindingRow kLoneCr{
    Severity::warning,
    false,
    "cr-line-end",
    PROVEOUT_TEXT("Core", "CR line end"),
    PROVEOUT_TEXT("Core", "The line ends with CR alone, which LinuxCNC does not accept as a line end."),
    PROVEOUT_TEXT("Core", "Save the file with LF or CR LF line ends.")};
inline constexpr FindingRow kNoPoint{
    Severity::warning,
    false,
    "no-decimal-point",
    PROVEOUT_TEXT("Core", "No decimal point"),
    PROVEOUT_TEXT(
        "Core", "{} has no decimal point: the control reads it as {}; one with calculator-type input as {}."),
    PROVEOUT_TEXT("Core", "Write the decimal point.")};

inline constexpr std::array kLineRows{
    &kBadCharacter,     &kNumberMissing,       &kDoubleSign,      &kTwoPoints,       &kNumberOutOfRange,
    &kCommentUnclosed,  &kCommentNested,       &kWordTwice,       &kLastWordCounts,  &kTooManyCodes,
    &kBlockNumberPlace, &kBlockNumberNegative, &kBlockNumberLong, &kPercentNotAlone, &kLineLong,
    &kControlCode,      &kByteOrderMark,       &kLoneCr,          &kNoPoint};

} // namespace proveout::nc_message
