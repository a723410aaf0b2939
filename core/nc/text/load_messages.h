// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about what keeps a program from being read: its file, its dialect, and the list of its ignored
// codes.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kEncoding{
    Severity::error,
    true,
    "nc-encoding",
    PROVEOUT_TEXT("Core", "Unsupported encoding"),
    PROVEOUT_TEXT("Core", "The file is encoded in {}, not in ASCII or UTF-8."),
    PROVEOUT_TEXT("Core", "Save it as plain text (ASCII or UTF-8) and open it again.")};
inline constexpr FindingRow kBinaryKind{
    Severity::error,
    true,
    "nc-binary",
    PROVEOUT_TEXT("Core", "Binary file"),
    PROVEOUT_TEXT("Core", "This is {}, not an NC program."),
    PROVEOUT_TEXT("Core", "Choose the text file that the machine would run.")};
inline constexpr FindingRow kBinary{
    Severity::error,
    true,
    "nc-binary",
    PROVEOUT_TEXT("Core", "Binary file"),
    PROVEOUT_TEXT("Core", "This is not an NC program: it holds binary data."),
    PROVEOUT_TEXT("Core", "Choose the text file that the machine would run.")};
inline constexpr FindingRow kDialectForeign{
    Severity::error,
    true,
    "dialect-foreign",
    PROVEOUT_TEXT("Core", "Unsupported dialect"),
    PROVEOUT_TEXT("Core", "This is {} (line {}: {}), which Proveout does not read."),
    PROVEOUT_TEXT("Core",
                  "Post-process it for one of these dialects: {4}; if it is in one of them after all, "
                  "choose it.")};
inline constexpr FindingRow kNotAProgram{
    Severity::error,
    true,
    "not-a-program",
    PROVEOUT_TEXT("Core", "Not an NC program"),
    PROVEOUT_TEXT("Core", "This is {} (line {}: {}), not an NC program."),
    PROVEOUT_TEXT("Core", "Open the program that the machine would run; if this is it, choose its dialect.")};
inline constexpr FindingRow kCodeList{
    Severity::error,
    false,
    "m-code-list",
    PROVEOUT_TEXT("Core", "Invalid M code list"),
    PROVEOUT_TEXT("Core", "\"{}\" is not an M code; write numbers from 0 to {}, for example 10, 11, 16."),
    ""};

inline constexpr std::array kLoadRows{&kEncoding,       &kBinaryKind,  &kBinary,
                                      &kDialectForeign, &kNotAProgram, &kCodeList};

} // namespace proveout::nc_message
