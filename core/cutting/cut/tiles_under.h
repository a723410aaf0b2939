// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/cutting/cut/sweep.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Adds the tiles, ascending, that a sweep may lower: those under it, except those that are entirely below
/// the cutter or entirely on the floor.
void tilesToLower(const ZMap& zmap, const Sweep& sweep, std::vector<std::size_t>& tiles);

} // namespace proveout
