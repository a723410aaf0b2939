// SPDX-License-Identifier: GPL-3.0-or-later
// Findings that only the window reports: files, work in the background and export.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::window_finding {

inline constexpr FindingRow kBackupDamaged{Severity::error,
                                           false,
                                           "record-unreadable",
                                           PROVEOUT_TEXT("Core", "Backup damaged"),
                                           PROVEOUT_TEXT("Core", "The backup of this session is damaged."),
                                           ""};
inline constexpr FindingRow kBackupFailed{
    Severity::error,
    false,
    "internal-error",
    PROVEOUT_TEXT("Core", "Internal error"),
    PROVEOUT_TEXT("Core", "Unsaved changes are no longer backed up: {}."),
    ""};
inline constexpr FindingRow kReadingOutOfMemory{
    Severity::error,
    false,
    "out-of-memory",
    PROVEOUT_TEXT("Core", "Out of memory"),
    PROVEOUT_TEXT("Core", "There is not enough memory to read the file."),
    ""};
inline constexpr FindingRow kReadingFailed{Severity::error,
                                           false,
                                           "internal-error",
                                           PROVEOUT_TEXT("Core", "Internal error"),
                                           PROVEOUT_TEXT("Core", "Reading the file failed: {}."),
                                           ""};
inline constexpr FindingRow kOpeningStopped{
    Severity::error,
    false,
    "opening-stopped",
    PROVEOUT_TEXT("Core", "File not opened"),
    PROVEOUT_TEXT(
        "Core", "The file was not opened because the open program was edited while the file was being read."),
    ""};
inline constexpr FindingRow kFileChangedOnDisk{
    Severity::error,
    false,
    "file-changed-on-disk",
    PROVEOUT_TEXT("Core", "File changed on disk"),
    PROVEOUT_TEXT("Core", "The file has changed on disk; it was not overwritten."),
    ""};
inline constexpr FindingRow kInterpretingOutOfMemory{
    Severity::error,
    false,
    "out-of-memory",
    PROVEOUT_TEXT("Core", "Out of memory"),
    PROVEOUT_TEXT("Core", "There is not enough memory to interpret the program."),
    ""};
inline constexpr FindingRow kInterpretingFailed{Severity::error,
                                                false,
                                                "internal-error",
                                                PROVEOUT_TEXT("Core", "Internal error"),
                                                PROVEOUT_TEXT("Core", "Interpreting the program failed: {}."),
                                                ""};
inline constexpr FindingRow kStockChangedOnDisk{
    Severity::warning,
    true,
    "stock-changed-on-disk",
    PROVEOUT_TEXT("Core", "Stock file changed"),
    PROVEOUT_TEXT("Core",
                  "The stock file has changed on disk; the simulation still uses the version read before."),
    PROVEOUT_TEXT("Core", "Reload the stock in the Setup panel, or keep the current version.")};
inline constexpr FindingRow kStockOutOfMemory{
    Severity::error,
    false,
    "stock-out-of-memory",
    PROVEOUT_TEXT("Core", "Stock too large"),
    PROVEOUT_TEXT("Core", "There is not enough memory for the stock."),
    ""};
inline constexpr FindingRow kNoStock{Severity::error,
                                     false,
                                     "no-stock",
                                     PROVEOUT_TEXT("Core", "No stock"),
                                     PROVEOUT_TEXT("Core", "There is no stock to export yet."),
                                     ""};
inline constexpr FindingRow kExportRunning{
    Severity::error,
    false,
    "export-running",
    PROVEOUT_TEXT("Core", "Export in progress"),
    PROVEOUT_TEXT("Core", "A file is still being written. Wait for it, or cancel it."),
    ""};
inline constexpr FindingRow kExportNeedsTooMuchMemory{
    Severity::error,
    false,
    "export-needs-too-much-memory",
    PROVEOUT_TEXT("Core", "Export too large"),
    PROVEOUT_TEXT("Core", "The export needs {} of memory; only {} is available."),
    PROVEOUT_TEXT("Core", "Increase the grid spacing, or close other programs.")};
inline constexpr FindingRow kExportNeedsCoarserGrid{
    Severity::error,
    false,
    "export-needs-too-much-memory",
    PROVEOUT_TEXT("Core", "Export too large"),
    PROVEOUT_TEXT("Core",
                  "The export needs {} of memory; only {} is available, enough for a grid spacing of {} mm."),
    PROVEOUT_TEXT("Core", "Increase the grid spacing, or close other programs.")};
inline constexpr FindingRow kExportSurfaceTooLarge{
    Severity::error,
    false,
    "export-needs-too-much-memory",
    PROVEOUT_TEXT("Core", "Export too large"),
    PROVEOUT_TEXT("Core", "The surface needs more than the {} of memory that are available; any surface on a "
                          "grid of {} mm would fit."),
    PROVEOUT_TEXT("Core", "Increase the grid spacing or the allowance, or close other programs.")};
inline constexpr FindingRow kExportFailed{Severity::error,
                                          false,
                                          "export-failed",
                                          PROVEOUT_TEXT("Core", "Export failed"),
                                          PROVEOUT_TEXT("Core", "The export failed: {}."),
                                          ""};
inline constexpr FindingRow kDetailOutOfMemory{
    Severity::error,
    false,
    "box-out-of-memory",
    PROVEOUT_TEXT("Core", "Detail region too large"),
    PROVEOUT_TEXT("Core", "There is not enough memory for the detail region."),
    ""};
inline constexpr FindingRow kDetailFailed{Severity::error,
                                          false,
                                          "internal-error",
                                          PROVEOUT_TEXT("Core", "Internal error"),
                                          PROVEOUT_TEXT("Core", "The detail region could not be cut: {}."),
                                          ""};
inline constexpr FindingRow kBlockSearchFailed{
    Severity::error,
    false,
    "internal-error",
    PROVEOUT_TEXT("Core", "Internal error"),
    PROVEOUT_TEXT("Core", "The block that cut this point could not be found: {}."),
    ""};
inline constexpr FindingRow kStudyOutOfMemory{
    Severity::error,
    false,
    "out-of-memory",
    PROVEOUT_TEXT("Core", "Out of memory"),
    PROVEOUT_TEXT("Core", "There is not enough memory for the study."),
    ""};
inline constexpr FindingRow kStudyFailed{Severity::error,
                                         false,
                                         "internal-error",
                                         PROVEOUT_TEXT("Core", "Internal error"),
                                         PROVEOUT_TEXT("Core", "The study failed: {}."),
                                         ""};
inline constexpr FindingRow kOpenGlMissing{Severity::error,
                                           false,
                                           "opengl-missing",
                                           PROVEOUT_TEXT("Core", "OpenGL not available"),
                                           PROVEOUT_TEXT("Core", "OpenGL 3.3 is not available."),
                                           ""};

inline constexpr std::array kWindowRows{&kBackupDamaged,
                                        &kBackupFailed,
                                        &kReadingOutOfMemory,
                                        &kReadingFailed,
                                        &kOpeningStopped,
                                        &kFileChangedOnDisk,
                                        &kInterpretingOutOfMemory,
                                        &kInterpretingFailed,
                                        &kStockChangedOnDisk,
                                        &kStockOutOfMemory,
                                        &kNoStock,
                                        &kExportRunning,
                                        &kExportNeedsTooMuchMemory,
                                        &kExportNeedsCoarserGrid,
                                        &kExportSurfaceTooLarge,
                                        &kExportFailed,
                                        &kDetailOutOfMemory,
                                        &kDetailFailed,
                                        &kBlockSearchFailed,
                                        &kStudyOutOfMemory,
                                        &kStudyFailed,
                                        &kOpenGlMissing};

} // namespace proveout::window_finding
