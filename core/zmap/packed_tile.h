// SPDX-License-Identifier: GPL-3.0-or-later
// Packs tiles to save memory, for snapshots that are not in view.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/zmap/zmap.h"

namespace proveout {

/// Packs a tile without loss, including its bounds: heights as integers, predicted from the neighbours to the
/// left and below, the bytes of equal weight together, then zstd at its fastest level. Takes some 20 µs; a
/// smooth surface needs a half to a third of its bytes, an uncut tile next to none.
[[nodiscard]] std::vector<std::byte> packed(const Tile& tile);

/// Restores the tile, bit for bit. `bytes` come from packed().
void unpack(std::span<const std::byte> bytes, Tile& tile);

} // namespace proveout
