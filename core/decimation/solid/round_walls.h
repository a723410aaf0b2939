// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this library.
#pragma once

#include "core/decimation/solid/solid_frame.h"

namespace proveout {

/// The points of a wall are on it, but on a coarse grid the straight edges between them cut off what is
/// round: divides the edges of walls along the curve through their ends, at a right angle to the normals
/// there, until they are within `tolerance` (mm) of it. `solid` stays closed.
void roundWalls(const SolidFrame& frame, double tolerance, TriangleMesh& solid);

} // namespace proveout
