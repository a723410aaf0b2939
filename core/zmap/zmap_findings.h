// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about the stock and its grid.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::zmap_finding {

inline constexpr FindingRow kOutlineOutOfRange{
    Severity::error,
    false,
    "outline-out-of-range",
    PROVEOUT_TEXT("Core", "Outline out of range"),
    PROVEOUT_TEXT("Core", "The outline has a point beyond {} mm, or an arc that is nearly a full circle."),
    ""};
inline constexpr FindingRow kOutlineWithoutArea{Severity::error,
                                                false,
                                                "outline-without-area",
                                                PROVEOUT_TEXT("Core", "Outline without area"),
                                                PROVEOUT_TEXT("Core", "The outline encloses no area."),
                                                ""};
inline constexpr FindingRow kOutlineCrossesItself{
    Severity::error,
    false,
    "outline-crosses-itself",
    PROVEOUT_TEXT("Core", "Outline crosses itself"),
    PROVEOUT_TEXT("Core", "The outline crosses itself near X{} Y{}."),
    ""};
inline constexpr FindingRow kGridSpacingBad{
    Severity::error,
    false,
    "grid-spacing-bad",
    PROVEOUT_TEXT("Core", "Invalid grid spacing"),
    PROVEOUT_TEXT("Core", "The grid spacing {} mm is not a number above 0."),
    ""};
inline constexpr FindingRow kStockSizeBad{
    Severity::error,
    false,
    "stock-size-bad",
    PROVEOUT_TEXT("Core", "Invalid stock size"),
    PROVEOUT_TEXT("Core", "Each side of the stock {} must be above 0 and at most {} mm."),
    ""};
inline constexpr FindingRow kStockSizeNarrow{
    Severity::error,
    false,
    "stock-size-narrow",
    PROVEOUT_TEXT("Core", "Stock too narrow"),
    PROVEOUT_TEXT("Core",
                  "The stock {} is too narrow: its sides in X and Y may differ by a factor of {} at most."),
    ""};
inline constexpr FindingRow kStockOriginBad{
    Severity::error,
    false,
    "stock-origin-bad",
    PROVEOUT_TEXT("Core", "Invalid stock origin"),
    PROVEOUT_TEXT("Core", "The origin of the stock is not three numbers from -{} to {} mm."),
    ""};
inline constexpr FindingRow kGridTooCoarse{
    Severity::error,
    false,
    "grid-too-coarse",
    PROVEOUT_TEXT("Core", "Grid too coarse"),
    PROVEOUT_TEXT("Core",
                  "The grid spacing {} mm is too coarse for the stock {}; the coarsest possible is {} mm."),
    ""};
inline constexpr FindingRow kGridTooFine{
    Severity::error,
    false,
    "grid-too-fine",
    PROVEOUT_TEXT("Core", "Grid too fine"),
    PROVEOUT_TEXT("Core", "The grid spacing {} mm makes {} points on the stock {}, {} of memory; the finest "
                          "possible is {} mm."),
    ""};
inline constexpr FindingRow kGridLostInRounding{
    Severity::error,
    false,
    "grid-lost-in-rounding",
    PROVEOUT_TEXT("Core", "Grid lost in rounding"),
    PROVEOUT_TEXT("Core", "The grid spacing {} mm is lost in the rounding of coordinates as large as {} mm."),
    ""};
inline constexpr FindingRow kMemoryTooSmall{Severity::error,
                                            false,
                                            "memory-too-small",
                                            PROVEOUT_TEXT("Core", "Not enough memory"),
                                            PROVEOUT_TEXT("Core", "The z-map needs {}; {} is available."),
                                            ""};
inline constexpr FindingRow kGridNeedsTooMuchMemory{
    Severity::error,
    false,
    "grid-needs-too-much-memory",
    PROVEOUT_TEXT("Core", "Grid needs too much memory"),
    PROVEOUT_TEXT("Core",
                  "A grid of {} × {} points needs {}; {} is available, enough for a spacing of {} mm."),
    ""};
inline constexpr FindingRow kBoxWithoutArea{
    Severity::error,
    false,
    "box-without-area",
    PROVEOUT_TEXT("Core", "Box without area"),
    PROVEOUT_TEXT("Core",
                  "The box {} has no area: each side must go from the smaller coordinate to the larger one."),
    ""};
inline constexpr FindingRow kBoxOutsideStock{Severity::error,
                                             false,
                                             "box-outside-stock",
                                             PROVEOUT_TEXT("Core", "Box outside the stock"),
                                             PROVEOUT_TEXT("Core", "The box {} is not within the stock, {}."),
                                             ""};
inline constexpr FindingRow kStockMeshFar{
    Severity::error,
    false,
    "stock-mesh-far",
    PROVEOUT_TEXT("Core", "Stock mesh too far"),
    PROVEOUT_TEXT("Core", "The mesh of the stock reaches beyond {} mm."),
    ""};
inline constexpr FindingRow kStockMeshFlat{Severity::error,
                                           false,
                                           "stock-mesh-flat",
                                           PROVEOUT_TEXT("Core", "Stock mesh flat"),
                                           PROVEOUT_TEXT("Core", "The mesh of the stock encloses no volume."),
                                           ""};
inline constexpr FindingRow kStockMeshLayers{
    Severity::error,
    false,
    "stock-mesh-layers",
    PROVEOUT_TEXT("Core", "Too many mesh layers"),
    PROVEOUT_TEXT("Core",
                  "The facets of the stock mesh are in {} layers on average; at most {} can be read."),
    ""};
inline constexpr FindingRow kStockNothingLeft{Severity::error,
                                              false,
                                              "stock-nothing-left",
                                              PROVEOUT_TEXT("Core", "Saved stock empty"),
                                              PROVEOUT_TEXT("Core", "No stock is left in the saved stock."),
                                              ""};
inline constexpr FindingRow kStockSizeForm{
    Severity::error,
    false,
    "stock-size-form",
    PROVEOUT_TEXT("Core", "Invalid stock size text"),
    PROVEOUT_TEXT("Core", "“{}” is not a stock size of the form WxDxH in mm, as in {}."),
    ""};
inline constexpr FindingRow kStockSizeNotPositive{
    Severity::error,
    false,
    "stock-size-not-positive",
    PROVEOUT_TEXT("Core", "Stock size not positive"),
    PROVEOUT_TEXT("Core", "Every side of the stock must be more than 0 mm, not “{}”."),
    ""};
inline constexpr FindingRow kPointForm{Severity::error,
                                       false,
                                       "point-form",
                                       PROVEOUT_TEXT("Core", "Invalid point"),
                                       PROVEOUT_TEXT("Core", "“{}” is not a point of the form X,Y,Z in mm."),
                                       ""};
inline constexpr FindingRow kStockIncompleteNoFile{
    Severity::error,
    false,
    "stock-incomplete",
    PROVEOUT_TEXT("Core", "Stock incomplete"),
    PROVEOUT_TEXT("Core", "The stock has no file yet; nothing is simulated."),
    PROVEOUT_TEXT("Core", "Choose the file of the stock, or another shape.")};
inline constexpr FindingRow kStockIncomplete{
    Severity::error,
    false,
    "stock-incomplete",
    PROVEOUT_TEXT("Core", "Stock incomplete"),
    PROVEOUT_TEXT("Core", "The stock cannot be made from {}; nothing is simulated."),
    kStockIncompleteNoFile.hint};

inline constexpr std::array kZmapRows{
    &kOutlineOutOfRange, &kOutlineWithoutArea,    &kOutlineCrossesItself, &kGridSpacingBad,
    &kStockSizeBad,      &kStockSizeNarrow,       &kStockOriginBad,       &kGridTooCoarse,
    &kGridTooFine,       &kGridLostInRounding,    &kMemoryTooSmall,       &kGridNeedsTooMuchMemory,
    &kBoxWithoutArea,    &kBoxOutsideStock,       &kStockMeshFar,         &kStockMeshFlat,
    &kStockMeshLayers,   &kStockNothingLeft,      &kStockSizeForm,        &kStockSizeNotPositive,
    &kPointForm,         &kStockIncompleteNoFile, &kStockIncomplete};

} // namespace proveout::zmap_finding
