// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about the body of a stock when it is made.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::stock_body_finding {

inline constexpr FindingRow kStockMeshOpen{
    Severity::error,
    true,
    "stock-mesh-open",
    PROVEOUT_TEXT("Core", "Stock mesh not closed"),
    PROVEOUT_TEXT("Core",
                  "The mesh of the stock is not closed: at {} of {} grid points the material is unknown."),
    PROVEOUT_TEXT("Core", "Export the stock as a closed solid.")};
inline constexpr FindingRow kStockUndercut{
    Severity::error,
    true,
    "stock-undercut",
    PROVEOUT_TEXT("Core", "Undercut in stock"),
    PROVEOUT_TEXT("Core", "Below the surface of the stock there are {} mm³ of air, which the z-map shows as "
                          "material; the tallest gap, {} mm, starts at X{} Y{} Z{}."),
    PROVEOUT_TEXT("Core", "Check the program over such gaps by other means.")};
inline constexpr FindingRow kStockResampled{
    Severity::note,
    false,
    "stock-resampled",
    PROVEOUT_TEXT("Core", "Stock resampled"),
    PROVEOUT_TEXT("Core", "The saved stock has a spacing of {} × {} mm and is resampled to {} × {} mm: never "
                          "lower at its points, between them up to one spacing wider."),
    PROVEOUT_TEXT("Core",
                  "Use the spacing of the saved stock, or a whole fraction of it, to avoid resampling.")};
inline constexpr FindingRow kStockWallsLost{
    Severity::note,
    false,
    "stock-walls-lost",
    PROVEOUT_TEXT("Core", "Stock walls at grid points"),
    PROVEOUT_TEXT("Core", "The walls of the saved stock are at grid points: they are known on its own grid, "
                          "with a spacing of {} × {} mm, and with its own height only."),
    PROVEOUT_TEXT("Core", "Use the spacing and the height of the saved stock to keep its walls.")};
inline constexpr FindingRow kStockMeshWalls{
    Severity::note,
    false,
    "stock-mesh-walls",
    PROVEOUT_TEXT("Core", "Stock walls at grid points"),
    PROVEOUT_TEXT("Core", "The walls of the stock mesh are at grid points: more than {} of its triangles, on "
                          "average, are over one place, too many to find walls between the points."),
    PROVEOUT_TEXT("Core", "Export the stock with triangles that are less long and narrow.")};

inline constexpr std::array kStockBodyRows{&kStockMeshOpen, &kStockUndercut, &kStockResampled,
                                           &kStockWallsLost, &kStockMeshWalls};

} // namespace proveout::stock_body_finding
