// SPDX-License-Identifier: GPL-3.0-or-later
// Errors that can occur with any file, and the counts of messages that are not shown.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::base_finding {

inline constexpr FindingRow kFileUnreadable{Severity::error,
                                            false,
                                            "file-unreadable",
                                            PROVEOUT_TEXT("Core", "File not readable"),
                                            PROVEOUT_TEXT("Core", "The file cannot be read: {}."),
                                            ""};
inline constexpr FindingRow kFileUnwritable{Severity::error,
                                            false,
                                            "file-unwritable",
                                            PROVEOUT_TEXT("Core", "File not writable"),
                                            PROVEOUT_TEXT("Core", "The file cannot be written: {}."),
                                            ""};
inline constexpr FindingRow kFileUnwritableSize{
    Severity::error,
    false,
    "file-unwritable",
    PROVEOUT_TEXT("Core", "File not writable"),
    PROVEOUT_TEXT("Core", "The file cannot be written ({} needed): {}."),
    ""};
inline constexpr FindingRow kFileNotRegularFolder{Severity::error,
                                                  false,
                                                  "file-not-regular",
                                                  PROVEOUT_TEXT("Core", "Not a regular file"),
                                                  PROVEOUT_TEXT("Core", "This is a folder, not a file."),
                                                  ""};
inline constexpr FindingRow kFileNotRegular{Severity::error,
                                            false,
                                            "file-not-regular",
                                            PROVEOUT_TEXT("Core", "Not a regular file"),
                                            PROVEOUT_TEXT("Core", "This is not a regular file."),
                                            ""};
inline constexpr FindingRow kFileTooLarge{Severity::error,
                                          false,
                                          "file-too-large",
                                          PROVEOUT_TEXT("Core", "File too large"),
                                          PROVEOUT_TEXT("Core", "The file has {}; the limit is {}."),
                                          ""};
inline constexpr FindingRow kCancelledReading{Severity::error,
                                              false,
                                              "cancelled",
                                              PROVEOUT_TEXT("Core", "Cancelled"),
                                              PROVEOUT_TEXT("Core", "Reading the file was cancelled."),
                                              ""};
inline constexpr FindingRow kTooManyMessages{Severity::warning,
                                             false,
                                             "too-many-messages",
                                             PROVEOUT_TEXT("Core", "More messages"),
                                             PROVEOUT_TEXT("Core", "{} more messages are not shown."),
                                             "",
                                             SeverityRule::worstOmitted};

inline constexpr std::array kBaseRows{&kFileUnreadable,       &kFileUnwritable, &kFileUnwritableSize,
                                      &kFileNotRegularFolder, &kFileNotRegular, &kFileTooLarge,
                                      &kCancelledReading,     &kTooManyMessages};

} // namespace proveout::base_finding
