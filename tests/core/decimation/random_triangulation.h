// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "core/decimation/regions/region_mesh.h"

namespace proveout::test {

/// The 4-8 triangulation of nx × ny points, written apart from the room.
[[nodiscard]] std::vector<LatticeTriangle> fullTriangulation(int nx, int ny);

/// A triangulation of the same rectangle that uses only some of its points, as a decimation would leave it:
/// random edge collapses wherever all triangles keep a positive area and the outline stays. The corners stay.
[[nodiscard]] std::vector<LatticeTriangle> randomTriangulation(int nx, int ny, std::size_t collapses,
                                                               std::mt19937& random);

} // namespace proveout::test
