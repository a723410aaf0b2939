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

/// Bytes of a file of one float or 32-bit number a point.
[[nodiscard]] std::uint64_t heightsBytes(int nx, int ny);

/// Writes absolute heights: row 0 at the least y, float32.
[[nodiscard]] Result<void> writeZMap(const std::filesystem::path& file, const ZMapSnapshot& zmap);

/// Writes source lines: of each point the one whose block lowered it last, 0 where none did; as writeZMap(),
/// but unsigned 32-bit integers.
[[nodiscard]] Result<void> writeProvenance(const std::filesystem::path& file, const Grid& grid,
                                           const Provenance& provenance, const Program& program);

/// Reads absolute heights as the top of a stock: point (row j, column i) at origin + (i, j) · spacing, floor
/// at `floor` or 5 mm below the least height. Errors: as readNpy; fewer than 2 × 2 points; heights that are
/// not finite or not above the floor; what `check` refuses, which is asked before the map takes memory.
[[nodiscard]] Result<ZMapSnapshot>
readZMap(const std::filesystem::path& file, double spacing, Vec2 origin, std::optional<double> floor,
         const std::function<Result<void>(const StockBox&, const Grid&)>& check);

} // namespace proveout::cli
