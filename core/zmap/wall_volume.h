// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/zmap/zmap.h"

namespace proveout {

/// How much more volume the stock has with its walls where they stand than with those of the grid, mm³
/// (ZMapSnapshot::volume()); negative: less; 0: the map has no walls. Walls are round between two points if
/// their normals say so. Any thread.
[[nodiscard]] double volumeAtWalls(const ZMapSnapshot& zmap);

} // namespace proveout
