// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for every solid, checked without any code of core/decimation.
#pragma once

#include <string>

#include "core/decimation/solid/solid.h"

namespace proveout::test {

/// The first defect of a mesh that should be a closed, oriented 2-manifold without degenerate triangles, as a
/// sentence; empty if there is none. Coordinates are compared as float32, as in STL: all vertices must
/// differ, and all triangles must have an area and the same orientation as in double.
[[nodiscard]] std::string whatIsWrong(const TriangleMesh& mesh);

/// Volume by the divergence theorem, mm³; positive where the triangles face outwards.
[[nodiscard]] double signedVolume(const TriangleMesh& mesh);

/// The smallest signed volume of the connected parts; all must be positive.
[[nodiscard]] double smallestPartVolume(const TriangleMesh& mesh);

/// The number of connected parts.
[[nodiscard]] std::size_t partCount(const TriangleMesh& mesh);

} // namespace proveout::test
