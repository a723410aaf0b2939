// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "core/decimation/regions/region_mesh.h"

namespace proveout::test {

/// The 4-8 triangulation of nx × ny points, implemented independently of the product's code.
[[nodiscard]] std::vector<LatticeTriangle> fullTriangulation(int nx, int ny);

/// A triangulation of the same rectangle that uses only some of its points, as decimation would produce:
/// random edge collapses that keep the area of all triangles positive and the outline and corners unchanged.
[[nodiscard]] std::vector<LatticeTriangle> randomTriangulation(int nx, int ny, std::size_t collapses,
                                                               std::mt19937& random);

} // namespace proveout::test
