// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about job files: their JSON, their fields and the files that they name.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::job_finding {

inline constexpr FindingRow kJsonDepth{
    Severity::error,
    false,
    "json-depth",
    PROVEOUT_TEXT("Core", "JSON nested too deeply"),
    PROVEOUT_TEXT("Core", "The brackets are nested deeper than {} levels."),
    ""};
inline constexpr FindingRow kJsonSyntax{Severity::error,
                                        false,
                                        "json-syntax",
                                        PROVEOUT_TEXT("Core", "Not valid JSON"),
                                        PROVEOUT_TEXT("Core", "This is not valid JSON."),
                                        ""};
inline constexpr FindingRow kNotAJob{
    Severity::error,
    false,
    "not-a-job",
    PROVEOUT_TEXT("Core", "Not a Proveout job"),
    PROVEOUT_TEXT(
        "Core",
        "This is not a Proveout job: the field \"proveout\" with the number of its format is missing."),
    ""};
inline constexpr FindingRow kJobNewer{
    Severity::error,
    false,
    "job-newer",
    PROVEOUT_TEXT("Core", "Job of newer version"),
    PROVEOUT_TEXT("Core",
                  "The job was written by a newer Proveout (format {}); this one reads up to format {}."),
    ""};
inline constexpr FindingRow kJobNotUtf8{
    Severity::error,
    false,
    "job-not-utf8",
    PROVEOUT_TEXT("Core", "Program name not UTF-8"),
    PROVEOUT_TEXT("Core", "The name of the program is not UTF-8, which JSON needs; rename it."),
    ""};
inline constexpr FindingRow kJobOutside{
    Severity::error,
    false,
    "job-outside",
    PROVEOUT_TEXT("Core", "File outside job folder"),
    PROVEOUT_TEXT("Core",
                  "The field \"{}\" names {}, which is outside the folder of the job; it was not read."),
    ""};
inline constexpr FindingRow kJobFieldUnknown{
    Severity::warning,
    false,
    "job-field-unknown",
    PROVEOUT_TEXT("Core", "Unknown job field"),
    PROVEOUT_TEXT("Core", "The field \"{}\" is not known and has no effect."),
    PROVEOUT_TEXT("Core", "Correct its name, or remove it.")};
inline constexpr FindingRow kJobFieldUnknownMeant{
    Severity::warning,
    false,
    "job-field-unknown",
    PROVEOUT_TEXT("Core", "Unknown job field"),
    PROVEOUT_TEXT("Core", "The field \"{}\" is not known and has no effect; perhaps \"{}\" is meant."),
    PROVEOUT_TEXT("Core", "Correct its name, or remove it.")};
inline constexpr FindingRow kJobFieldFormat{
    Severity::error,
    false,
    "job-field",
    PROVEOUT_TEXT("Core", "Invalid job field"),
    PROVEOUT_TEXT("Core", "The field \"{}\" must be the number of the format."),
    ""};
inline constexpr FindingRow kJobFieldMissing{Severity::error,
                                             false,
                                             "job-field",
                                             PROVEOUT_TEXT("Core", "Invalid job field"),
                                             PROVEOUT_TEXT("Core", "The field \"{}\" is missing."),
                                             ""};
inline constexpr FindingRow kJobFieldAbove{
    Severity::error,
    false,
    "job-field",
    PROVEOUT_TEXT("Core", "Invalid job field"),
    PROVEOUT_TEXT("Core", "The field \"{}\" must be a number above {} and at most {}."),
    ""};
inline constexpr FindingRow kJobFieldRange{
    Severity::error,
    false,
    "job-field",
    PROVEOUT_TEXT("Core", "Invalid job field"),
    PROVEOUT_TEXT("Core", "The field \"{}\" must be a number from {} to {}."),
    ""};
inline constexpr FindingRow kJobFieldText{Severity::error,
                                          false,
                                          "job-field",
                                          PROVEOUT_TEXT("Core", "Invalid job field"),
                                          PROVEOUT_TEXT("Core", "The field \"{}\" must be a text."),
                                          ""};
inline constexpr FindingRow kJobFieldEmpty{Severity::error,
                                           false,
                                           "job-field",
                                           PROVEOUT_TEXT("Core", "Invalid job field"),
                                           PROVEOUT_TEXT("Core", "The field \"{}\" must not be empty."),
                                           ""};
inline constexpr FindingRow kJobFieldWhole{Severity::error,
                                           false,
                                           "job-field",
                                           PROVEOUT_TEXT("Core", "Invalid job field"),
                                           PROVEOUT_TEXT("Core", "The field \"{}\" must be a whole number."),
                                           ""};
inline constexpr FindingRow kJobFieldFlag{Severity::error,
                                          false,
                                          "job-field",
                                          PROVEOUT_TEXT("Core", "Invalid job field"),
                                          PROVEOUT_TEXT("Core", "The field \"{}\" must be true or false."),
                                          ""};
inline constexpr FindingRow kJobFieldPoint{
    Severity::error,
    false,
    "job-field",
    PROVEOUT_TEXT("Core", "Invalid job field"),
    PROVEOUT_TEXT("Core", "The field \"{}\" must be three numbers [x, y, z]."),
    ""};
inline constexpr FindingRow kJobFieldList{
    Severity::error,
    false,
    "job-field",
    PROVEOUT_TEXT("Core", "Invalid job field"),
    PROVEOUT_TEXT("Core", "The field \"{}\" must be a list of whole numbers from 0 to {}."),
    ""};
inline constexpr FindingRow kJobFieldChoice{Severity::error,
                                            false,
                                            "job-field",
                                            PROVEOUT_TEXT("Core", "Invalid job field"),
                                            PROVEOUT_TEXT("Core", "The field \"{}\" must be one of {}."),
                                            ""};
inline constexpr FindingRow kJobFieldObject{Severity::error,
                                            false,
                                            "job-field",
                                            PROVEOUT_TEXT("Core", "Invalid job field"),
                                            PROVEOUT_TEXT("Core", "The field \"{}\" must be an object { }."),
                                            ""};
inline constexpr FindingRow kJobFieldProgram{Severity::error,
                                             false,
                                             "job-field",
                                             PROVEOUT_TEXT("Core", "Invalid job field"),
                                             PROVEOUT_TEXT("Core", "The field \"{}\" must name a file."),
                                             ""};
inline constexpr FindingRow kJobFieldPosition{
    Severity::error,
    false,
    "job-field",
    PROVEOUT_TEXT("Core", "Invalid job field"),
    PROVEOUT_TEXT("Core", "The field \"{}\" and the fields minX, minY, topZ cannot be used together; they "
                          "are the same position."),
    ""};
inline constexpr FindingRow kJobFieldToolNumber{
    Severity::error,
    false,
    "job-field",
    PROVEOUT_TEXT("Core", "Invalid job field"),
    PROVEOUT_TEXT("Core", "\"{}\" is not a tool number; these are whole numbers from {} to {}."),
    ""};
inline constexpr FindingRow kJobFieldToolTwice{
    Severity::error,
    false,
    "job-field",
    PROVEOUT_TEXT("Core", "Invalid job field"),
    PROVEOUT_TEXT("Core", "The field \"{}\" names a tool that is in the table already."),
    ""};
inline constexpr FindingRow kJobFieldCutter{Severity::error,
                                            false,
                                            "job-field",
                                            PROVEOUT_TEXT("Core", "Invalid job field"),
                                            PROVEOUT_TEXT("Core", "The field \"{}\" is not a cutter: {}"),
                                            ""};
inline constexpr FindingRow kJobFieldFixture{Severity::error,
                                             false,
                                             "job-field",
                                             PROVEOUT_TEXT("Core", "Invalid job field"),
                                             PROVEOUT_TEXT("Core", "The field \"{}\" is not a fixture: {}"),
                                             ""};

inline constexpr std::array kJobRows{
    &kJsonDepth,        &kJsonSyntax,         &kNotAJob,           &kJobNewer,
    &kJobNotUtf8,       &kJobOutside,         &kJobFieldUnknown,   &kJobFieldUnknownMeant,
    &kJobFieldFormat,   &kJobFieldMissing,    &kJobFieldAbove,     &kJobFieldRange,
    &kJobFieldText,     &kJobFieldWhole,      &kJobFieldFlag,      &kJobFieldPoint,
    &kJobFieldList,     &kJobFieldChoice,     &kJobFieldObject,    &kJobFieldProgram,
    &kJobFieldPosition, &kJobFieldToolNumber, &kJobFieldToolTwice, &kJobFieldCutter,
    &kJobFieldFixture,  &kJobFieldEmpty};

} // namespace proveout::job_finding
