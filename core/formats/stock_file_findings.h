// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about stocks as text, as outlines and as saved by Proveout.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::stock_finding {

inline constexpr FindingRow kOutlineLine{
    Severity::error,
    false,
    "outline-line",
    PROVEOUT_TEXT("Core", "Invalid outline point"),
    PROVEOUT_TEXT("Core", "This line is not a point: X, Y and, for an arc, its bulge."),
    ""};
inline constexpr FindingRow kOutlineLoop{Severity::error,
                                         false,
                                         "outline-loop",
                                         PROVEOUT_TEXT("Core", "Outline loop too short"),
                                         PROVEOUT_TEXT("Core", "The loop that ends here has only one point."),
                                         ""};
inline constexpr FindingRow kOutlineEmpty{Severity::error,
                                          false,
                                          "outline-empty",
                                          PROVEOUT_TEXT("Core", "Outline empty"),
                                          PROVEOUT_TEXT("Core", "The outline has no points."),
                                          ""};
inline constexpr FindingRow kStockKeyUnknown{
    Severity::error,
    false,
    "stock-key-unknown",
    PROVEOUT_TEXT("Core", "Unknown stock key"),
    PROVEOUT_TEXT("Core", "“{}” is not a key of this stock shape; there are {}."),
    ""};
inline constexpr FindingRow kStockValueBad{
    Severity::error,
    false,
    "stock-value-bad",
    PROVEOUT_TEXT("Core", "Invalid stock value"),
    PROVEOUT_TEXT("Core", "{}={} is not a length above {} and at most {} mm."),
    ""};
inline constexpr FindingRow kStockChoiceUnknown{Severity::error,
                                                false,
                                                "stock-choice-unknown",
                                                PROVEOUT_TEXT("Core", "Invalid stock option"),
                                                PROVEOUT_TEXT("Core", "{}={} is not one of {}."),
                                                ""};
inline constexpr FindingRow kStockFileMissing{Severity::error,
                                              false,
                                              "stock-file-missing",
                                              PROVEOUT_TEXT("Core", "Stock file missing"),
                                              PROVEOUT_TEXT("Core", "The key {} must name a file."),
                                              ""};
inline constexpr FindingRow kStockKeyTwice{Severity::error,
                                           false,
                                           "stock-key-twice",
                                           PROVEOUT_TEXT("Core", "Duplicate stock key"),
                                           PROVEOUT_TEXT("Core", "The key {} is specified twice."),
                                           ""};
inline constexpr FindingRow kStockKeyMissing{
    Severity::error,
    false,
    "stock-key-missing",
    PROVEOUT_TEXT("Core", "Stock key missing"),
    PROVEOUT_TEXT("Core", "A stock of the shape {} needs the key {}, as in {}."),
    ""};
inline constexpr FindingRow kStockShapeUnknown{
    Severity::error,
    false,
    "stock-shape-unknown",
    PROVEOUT_TEXT("Core", "Unknown stock shape"),
    PROVEOUT_TEXT("Core", "“{}” is not a stock shape; there are {}."),
    ""};
inline constexpr FindingRow kStockFileBroken{
    Severity::error,
    false,
    "stock-file-broken",
    PROVEOUT_TEXT("Core", "Saved stock damaged"),
    PROVEOUT_TEXT("Core", "The saved stock is cut off or damaged: {} in it cannot be read whole."),
    ""};
inline constexpr FindingRow kNotAStock{Severity::error,
                                       false,
                                       "not-a-stock",
                                       PROVEOUT_TEXT("Core", "Not a saved stock"),
                                       PROVEOUT_TEXT("Core", "This is not a stock that Proveout has saved."),
                                       ""};
inline constexpr FindingRow kStockNewer{
    Severity::error,
    false,
    "stock-newer",
    PROVEOUT_TEXT("Core", "Stock of newer version"),
    PROVEOUT_TEXT("Core",
                  "The stock was saved by a newer Proveout (format {}); this one reads up to format {}."),
    ""};
inline constexpr FindingRow kStockGridDiffers{
    Severity::error,
    false,
    "stock-grid-differs",
    PROVEOUT_TEXT("Core", "Saved grid mismatch"),
    PROVEOUT_TEXT("Core", "The saved stock specifies {} × {} points, but its size and spacing give {} × {}."),
    ""};
inline constexpr FindingRow kStockHeightsForm{
    Severity::error,
    false,
    "stock-heights-form",
    PROVEOUT_TEXT("Core", "Saved heights invalid"),
    PROVEOUT_TEXT("Core", "The heights of the saved stock are not {} × {} numbers of float32."),
    ""};
inline constexpr FindingRow kStockHeightBad{
    Severity::error,
    false,
    "stock-height-bad",
    PROVEOUT_TEXT("Core", "Saved height invalid"),
    PROVEOUT_TEXT("Core", "Row {}, column {} of the saved stock is not a height within it."),
    ""};
inline constexpr FindingRow kStockNotUtf8{
    Severity::error,
    false,
    "stock-not-utf8",
    PROVEOUT_TEXT("Core", "Program name not UTF-8"),
    PROVEOUT_TEXT("Core", "The name of the program is not UTF-8, which JSON needs; rename it."),
    ""};

inline constexpr std::array kStockFileRows{
    &kOutlineLine,        &kOutlineLoop,      &kOutlineEmpty,  &kStockKeyUnknown,  &kStockValueBad,
    &kStockChoiceUnknown, &kStockFileMissing, &kStockKeyTwice, &kStockKeyMissing,  &kStockShapeUnknown,
    &kStockFileBroken,    &kNotAStock,        &kStockNewer,    &kStockGridDiffers, &kStockHeightsForm,
    &kStockHeightBad,     &kStockNotUtf8};

} // namespace proveout::stock_finding
