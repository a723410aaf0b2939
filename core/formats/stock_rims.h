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

/// The number of bytes of `count` rims.
[[nodiscard]] double bytesOfRims(std::size_t count);

/// Writes the entry: an array of `count` × 1 values of 24 bytes ("|V24"), little-endian: tile (uint32), edge,
/// high place, low place (uint16), sides, 0 (uint8), top, bottom (float32), normal (2 × int16), as struct Rim
/// has them; ascending by tile and edge. `count`: countOf() the rims.
void writeRims(ZipFile& zip, const RimMap& rims, std::size_t count);

/// Reads the next entry as the `count` rims of a map. Takes no more memory than what was read of them.
/// Nothing if it is not such an entry, or is damaged, or has a rim that is not on an edge of the map, not in
/// order, or not within the stock.
[[nodiscard]] std::optional<RimMap> readRims(ZipReader& zip, const ZMapSnapshot& zmap, std::size_t count);

} // namespace proveout
