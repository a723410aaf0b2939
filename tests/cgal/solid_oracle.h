// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/decimation/solid/solid.h"

namespace proveout::test {

enum class Intersections { skip, look };

/// What CGAL finds wrong with a solid: no polygon mesh, not valid, not closed, parts that do not bound a
/// volume with outward normals, triangles that intersect (slow: asked for). Empty where nothing is.
[[nodiscard]] std::string whatCgalFindsWrong(const TriangleMesh& mesh, Intersections intersections);

} // namespace proveout::test
