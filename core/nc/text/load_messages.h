// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a program from being read: its file, and the codes that it is read with.
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
inline constexpr FindingRow kCodeList{
    Severity::error,
    false,
    "m-code-list",
    PROVEOUT_TEXT("Core", "Invalid M code list"),
    PROVEOUT_TEXT("Core", "\"{}\" is not an M code; write numbers from 0 to {}, for example 10, 11, 16."),
    ""};

inline constexpr std::array kLoadRows{&kEncoding, &kBinaryKind, &kBinary, &kCodeList};

} // namespace proveout::nc_message
