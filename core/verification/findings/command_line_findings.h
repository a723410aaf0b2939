// SPDX-License-Identifier: GPL-3.0-or-later
// Findings that only the command line reports, both of proveout-cli and of the workstation: options and
// outputs. The window never shows these texts, so they are not marked for translation.
#pragma once

#include <array>

#include "core/base/finding_row.h"

namespace proveout::command_line_finding {

inline constexpr FindingRow kUsage{Severity::error, false, "usage", "Invalid command line", "{}.", ""};
inline constexpr FindingRow kOutputUnwritable{Severity::error,
                                              false,
                                              "output-unwritable",
                                              "Output not writable",
                                              "Cannot write to standard output.",
                                              ""};
inline constexpr FindingRow kOutputUnwritableReason{Severity::error,
                                                    false,
                                                    "output-unwritable",
                                                    "Output not writable",
                                                    "Cannot write to standard output: {}.",
                                                    ""};
inline constexpr FindingRow kCommandOutOfMemory{
    Severity::error, false, "out-of-memory", "Out of memory", "There is not enough memory.", ""};
inline constexpr FindingRow kSurfaceNeedsTooMuchMemory{
    Severity::error,
    false,
    "surface-needs-too-much-memory",
    "Surface needs too much memory",
    "The surface needs more memory than is available ({}); any surface on a grid of {} mm would fit.",
    "Choose a coarser grid or a larger allowance. All files without the surface were written."};
inline constexpr FindingRow kCommandFailed{
    Severity::error, false, "internal-error", "Internal error", "The command failed: {}.", ""};
inline constexpr FindingRow kNoProgram{
    Severity::error, false, "no-program", "No program", "No program: name an NC program or use --job.", ""};
inline constexpr FindingRow kNoStock{
    Severity::error, false, "no-stock", "No stock", "No stock: use --stock WxDxH or --job.", ""};
inline constexpr FindingRow kJobOutside{
    Severity::error,
    false,
    "job-outside",
    "File outside job folder",
    "The field \"{}\" names {}, which is outside the job folder; use --allow-outside if you trust the job.",
    ""};
inline constexpr FindingRow kToolTwice{
    Severity::error, false, "tool-twice", "Duplicate tool", "Tool {} is specified twice.", ""};
inline constexpr FindingRow kReportOfMany{Severity::error,
                                          false,
                                          "report-of-many",
                                          "Report of several programs",
                                          "A report is of one program; several are to be checked.",
                                          "Write one report for each program."};
inline constexpr FindingRow kNoPart{Severity::error,
                                    false,
                                    "part-missing",
                                    "Part missing",
                                    "A tolerance needs a design part.",
                                    "State the part with --part, or in the job file."};
inline constexpr FindingRow kStartOutOfRange{Severity::error,
                                             false,
                                             "start-out-of-range",
                                             "Start position out of range",
                                             "{}{} is out of range; positions must be from {} to {} mm.",
                                             ""};
inline constexpr FindingRow kCompensationStartUnused{
    Severity::warning,
    false,
    "compensation-start-unused",
    "Start-up type not used",
    "Cutter compensation start-up type B has no effect: {} has no start-up types.",
    ""};
inline constexpr FindingRow kPointForm{
    Severity::error, false, "point-form", "Invalid point", "“{}” is not a point. Enter X,Y in mm.", ""};
inline constexpr FindingRow kBoxForm{
    Severity::error, false, "box-form", "Invalid box", "“{}” is not a box. Enter X0,Y0,X1,Y1 in mm.", ""};
inline constexpr FindingRow kZmapTooSmall{Severity::error,
                                          false,
                                          "zmap-too-small",
                                          "Z-map too small",
                                          "A z-map needs at least 2 × 2 points; this one has {} × {}.",
                                          ""};
inline constexpr FindingRow kZmapNotFinite{Severity::error,
                                           false,
                                           "zmap-not-finite",
                                           "Height not finite",
                                           "Row {}, column {} is not a finite number.",
                                           ""};
inline constexpr FindingRow kFloorTooHigh{Severity::error,
                                          false,
                                          "floor-too-high",
                                          "Stock bottom too high",
                                          "The stock bottom, {} mm, must be below the heights, {} … {} mm.",
                                          ""};
inline constexpr FindingRow kOutputOverwrites{Severity::error,
                                              false,
                                              "output-overwrites",
                                              "Output overwrites another file",
                                              "This output would overwrite an input or another output.",
                                              ""};
inline constexpr FindingRow kOutputsLackSpace{Severity::error,
                                              false,
                                              "outputs-lack-space",
                                              "Not enough disk space",
                                              "The outputs need {} on this disk, but only {} is free.",
                                              ""};
inline constexpr FindingRow kBordersNotExported{
    Severity::error,
    false,
    "borders-not-exported",
    "Mesh with cracks",
    "Borders decimated per region leave cracks. They are for studies only and cannot be exported.",
    ""};
inline constexpr FindingRow kFolderUnwritable{Severity::error,
                                              false,
                                              "folder-unwritable",
                                              "Folder not writable",
                                              "The folder cannot be created: {}.",
                                              ""};
inline constexpr FindingRow kPictureFailed{
    Severity::error, false, "picture-failed", "Picture not drawn", "The picture cannot be drawn.", ""};
inline constexpr FindingRow kScreenshotFailed{
    Severity::error, false, "screenshot-failed", "Screenshot not saved", "No screenshot was saved: {}.", ""};

inline constexpr FindingRow kNothingToCheck{
    Severity::error, false, "no-program", "No program", "There is no program to check in these folders.", ""};
inline constexpr FindingRow kResultsUnwritable{Severity::error,
                                               false,
                                               "output-unwritable",
                                               "Output not writable",
                                               "The results cannot be added to this file: {}.",
                                               ""};
inline constexpr FindingRow kRuleForm{Severity::error,
                                      false,
                                      "rule-form",
                                      "Invalid rule",
                                      "“{}” is not a rule. Enter ID=off or ID:key=value.",
                                      ""};
inline constexpr FindingRow kRuleUnknown{Severity::error,          false,
                                         "rule-unknown",           "No such rule",
                                         "There is no rule “{}”.", "List them: proveout-cli rules."};
inline constexpr FindingRow kRuleKeyUnknown{
    Severity::error, false, "rule-key-unknown", "No such limit", "There is no limit “{}”.", ""};
inline constexpr FindingRow kRuleValueBad{
    Severity::error, false, "rule-value-bad", "Invalid limit", "“{}” is not a valid value for {}.", ""};
inline constexpr FindingRow kAcceptUnknown{Severity::error,
                                           false,
                                           "accept-unknown",
                                           "Nothing to accept",
                                           "“{}” is not the id of anything that may be left unchecked.",
                                           ""};

inline constexpr std::array kCommandLineRows{&kUsage,
                                             &kOutputUnwritable,
                                             &kOutputUnwritableReason,
                                             &kCommandOutOfMemory,
                                             &kSurfaceNeedsTooMuchMemory,
                                             &kCommandFailed,
                                             &kNoProgram,
                                             &kNoStock,
                                             &kJobOutside,
                                             &kToolTwice,
                                             &kNoPart,
                                             &kReportOfMany,
                                             &kStartOutOfRange,
                                             &kCompensationStartUnused,
                                             &kPointForm,
                                             &kBoxForm,
                                             &kZmapTooSmall,
                                             &kZmapNotFinite,
                                             &kFloorTooHigh,
                                             &kOutputOverwrites,
                                             &kOutputsLackSpace,
                                             &kBordersNotExported,
                                             &kFolderUnwritable,
                                             &kPictureFailed,
                                             &kScreenshotFailed,
                                             &kNothingToCheck,
                                             &kResultsUnwritable,
                                             &kRuleForm,
                                             &kRuleUnknown,
                                             &kRuleKeyUnknown,
                                             &kRuleValueBad,
                                             &kAcceptUnknown};

} // namespace proveout::command_line_finding
