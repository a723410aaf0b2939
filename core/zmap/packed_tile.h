// SPDX-License-Identifier: GPL-3.0-or-later
// Tiles in little memory, for moments that nobody looks at now.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/zmap/zmap.h"

namespace proveout {

/// Packs a tile without loss, its bounds too: heights as integers, predicted from the neighbours to the left
/// and below, the bytes of equal weight together, then zstd at its fastest level. Some 20 µs; a smooth
/// surface takes a half to a third of its bytes, an uncut tile next to none.
[[nodiscard]] std::vector<std::byte> packed(const Tile& tile);

/// The tile again, bit for bit. `bytes` are those of packed().
void unpack(std::span<const std::byte> bytes, Tile& tile);

} // namespace proveout
