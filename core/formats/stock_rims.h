// SPDX-License-Identifier: GPL-3.0-or-later
// The rims of a saved stock as the entry `rims.npy` of its file. Internal to this library.
#pragma once

#include <cstddef>
#include <optional>

#include "core/formats/zip_file.h"
#include "core/formats/zip_reader.h"
#include "core/zmap/rims.h"
#include "core/zmap/zmap.h"

namespace proveout {

inline constexpr const char* kRimsEntry = "rims.npy";

/// The number of values that the entry has; 0: there is nothing to be written.
[[nodiscard]] std::size_t rimValues(const RimMap& rims);

/// The most values of a map with so many points.
[[nodiscard]] double mostRimValues(double points);

/// Whether a Proveout that knows rims only, and neither unseen ribs nor unknown tiles, can read the entry.
[[nodiscard]] bool areRimsOnly(const RimMap& rims);

/// The number of bytes of `count` values.
[[nodiscard]] double bytesOfRims(std::size_t count);

/// Writes the entry: an array of `count` × 1 values of 24 bytes ("|V24"), little-endian: tile (uint32), edge,
/// high place, low place (uint16), sides, 0 (uint8), top, bottom (float32), normal (2 × int16), as struct Rim
/// has them. `sides` is 3 for an edge that a rib crosses unseen, and 4, with the first edge, for a tile of
/// which rims are unknown; what follows is 0 then. Ascending by tile, edge and sides, of which those of rims
/// count as equal. `count`: rimValues().
void writeRims(ZipFile& zip, const RimMap& rims, std::size_t count);

/// Reads the next entry as the `count` values of a map. Takes no more memory than what was read of them.
/// Nothing if it is not such an entry, or is damaged, or has a value that is not of an edge of the map, not
/// in order, or not within the stock.
[[nodiscard]] std::optional<RimMap> readRims(ZipReader& zip, const ZMapSnapshot& zmap, std::size_t count);

} // namespace proveout
