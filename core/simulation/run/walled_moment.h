// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/run/frame.h"

namespace proveout {

/// Gives a moment its rims and walls, and counts them in its removed volume, which is that at the points of
/// the grid until then. `uncut`: the map of the uncut stock; null: the whole box. Any thread.
void addWalls(Frame& moment, const ZMapSnapshot* uncut);

} // namespace proveout
