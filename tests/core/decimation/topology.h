// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for every surface, checked without any code of core/decimation.
#pragma once

#include <span>

#include "core/decimation/regions/region_mesh.h"
#include "tests/core/decimation/maps.h"

namespace proveout::test {

/// Expects that the triangles cover a map of nx × ny points exactly once: all with positive area, every
/// directed edge once, every edge with its twin except along the outline of the map, and areas that add up to
/// that of the map. This excludes cracks, T-vertices, flipped and duplicate faces.
void expectCoversMap(int nx, int ny, std::span<const LatticeTriangle> triangles);

/// The largest vertical distance of a z-map point to the triangles, from the plane of each triangle, in long
/// double, over the bounding box of each: slow, simple, and independent of the product's code.
double bruteForceError(int nx, int ny, const Heights& heights, std::span<const LatticeTriangle> triangles);

} // namespace proveout::test
