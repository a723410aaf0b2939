// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/cutting/cut/sweep.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Adds the tiles, ascending, that a sweep may lower: those under it that are not below the cutter as a
/// whole, nor all on the floor.
void tilesToLower(const ZMap& zmap, const Sweep& sweep, std::vector<std::size_t>& tiles);

} // namespace proveout
