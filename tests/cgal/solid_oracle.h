// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/decimation/solid/solid.h"

namespace proveout::test {

enum class Intersections { skip, look };

/// The defects that CGAL finds in a solid: not a polygon mesh, not valid, not closed, parts that do not bound
/// a volume with outward normals, intersecting triangles (slow, so only on request). Empty if there are none.
[[nodiscard]] std::string whatCgalFindsWrong(const TriangleMesh& mesh, Intersections intersections);

} // namespace proveout::test
