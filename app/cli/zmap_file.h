// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/zmap/zmap.h"

namespace proveout::cli {

/// Writes absolute heights: row 0 at the least y, float32.
[[nodiscard]] Result<void> writeZMap(const std::filesystem::path& file, const ZMapSnapshot& zmap);

/// Reads absolute heights as the top of a stock: point (row j, column i) at origin + (i, j) · spacing, floor
/// at `floor` or 5 mm below the least height. Errors: as readNpy; fewer than 2 × 2 points; heights that are
/// not finite or not above the floor; what `check` refuses, which is asked before the map takes memory.
[[nodiscard]] Result<ZMapSnapshot>
readZMap(const std::filesystem::path& file, double spacing, Vec2 origin, std::optional<double> floor,
         const std::function<Result<void>(const StockBox&, const Grid&)>& check);

} // namespace proveout::cli
