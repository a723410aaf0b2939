// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/cutting/cut/provenance.h"
#include "core/nc/program/program.h"
#include "core/zmap/zmap.h"

namespace proveout::cli {

/// Size of a file with one float or 32-bit integer per point.
[[nodiscard]] std::uint64_t heightsBytes(int nx, int ny);

/// Writes absolute heights as float32; row 0 has the lowest y.
[[nodiscard]] Result<void> writeZMap(const std::filesystem::path& file, const ZMapSnapshot& zmap);

/// Writes source lines: for each point the line of the block that last lowered it, 0 if there is none; like
/// writeZMap(), but as unsigned 32-bit integers.
[[nodiscard]] Result<void> writeProvenance(const std::filesystem::path& file, const Grid& grid,
                                           const Provenance& provenance, const Program& program);

/// Reads absolute heights as the top of a stock: point (row j, column i) at origin + (i, j) · spacing, floor
/// at `floor` or 5 mm below the lowest height. Errors: those of readNpy; fewer than 2 × 2 points; heights
/// that are not finite or not above the floor; those of `check`, which is called before memory for the map is
/// allocated.
[[nodiscard]] Result<ZMapSnapshot>
readZMap(const std::filesystem::path& file, double spacing, Vec2 origin, std::optional<double> floor,
         const std::function<Result<void>(const StockBox&, const Grid&)>& check);

} // namespace proveout::cli
