// SPDX-License-Identifier: GPL-3.0-or-later
// Converts our meshes to those of CGAL. Only the two oracles include this, because it is slow to compile.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <optional>
#include <vector>

#include "core/decimation/solid/solid.h"

namespace proveout::test {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Empty if CGAL does not accept the triangles as a polygon mesh (an edge with three triangles, or two with
/// opposite orientations).
inline std::optional<SurfaceMesh> toSurfaceMesh(const TriangleMesh& mesh) {
    namespace pmp = CGAL::Polygon_mesh_processing;
    std::vector<Kernel::Point_3> points;
    for (const Vec3& vertex : mesh.vertices)
        points.emplace_back(vertex.x, vertex.y, vertex.z);
    std::vector<std::vector<std::size_t>> triangles;
    for (const auto& triangle : mesh.triangles)
        triangles.emplace_back(triangle.begin(), triangle.end());
    if (!pmp::is_polygon_soup_a_polygon_mesh(triangles))
        return std::nullopt;
    SurfaceMesh out;
    pmp::polygon_soup_to_polygon_mesh(points, triangles, out);
    return out;
}

} // namespace proveout::test
