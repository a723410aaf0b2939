// SPDX-License-Identifier: GPL-3.0-or-later
// What must be true of every solid, checked without any of the room's own code.
#pragma once

#include <string>

#include "core/decimation/solid/solid.h"

namespace proveout::test {

/// The first thing wrong with a mesh that should be a closed, oriented 2-manifold without degenerate
/// triangles, as a sentence; empty where nothing is. Coordinates are looked at as float32, as STL has them:
/// all vertices apart, all triangles with an area, and facing where they face in double.
[[nodiscard]] std::string whatIsWrong(const TriangleMesh& mesh);

/// Volume by the divergence theorem, mm³; positive where the triangles face outwards.
[[nodiscard]] double signedVolume(const TriangleMesh& mesh);

/// The smallest signed volume of the connected parts; all must be positive.
[[nodiscard]] double smallestPartVolume(const TriangleMesh& mesh);

/// How many connected parts.
[[nodiscard]] std::size_t partCount(const TriangleMesh& mesh);

} // namespace proveout::test
