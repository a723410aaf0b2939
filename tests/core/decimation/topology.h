// SPDX-License-Identifier: GPL-3.0-or-later
// What must be true of every surface, checked without any of the room's own code.
#pragma once

#include <span>

#include "core/decimation/regions/region_mesh.h"
#include "tests/core/decimation/maps.h"

namespace proveout::test {

/// Expects that the triangles cover a map of nx × ny points exactly once: every one of positive area, every
/// directed edge once, every edge with its twin except along the outline of the map, areas summing up to the
/// map's. With that there is no crack, no T-vertex, no flipped and no duplicate face.
void expectCoversMap(int nx, int ny, std::span<const LatticeTriangle> triangles);

/// The largest vertical distance of a z-map point to the triangles, by the plane through each triangle, in
/// long double, over the bounding box of each: slow, plain, and written apart from the room.
double bruteForceError(int nx, int ny, const Heights& heights, std::span<const LatticeTriangle> triangles);

} // namespace proveout::test
