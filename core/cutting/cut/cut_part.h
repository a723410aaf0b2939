// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a part of a map exactly as if the whole map were present.
#pragma once

#include <span>
#include <stop_token>

#include "core/cutting/cut/cutting.h"
#include "core/zmap/grid_part.h"

namespace proveout {

/// cutHeights() of a map whose points are those of `place`, which begins at a tile of the whole grid: the
/// heights equal those of the whole map to the last bit.
[[nodiscard]] bool cutHeights(ZMap& zmap, const GridPart& place, std::span<const CutterMotion> motions,
                              const std::stop_token& stop);

} // namespace proveout
