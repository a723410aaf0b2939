// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cgal/solid_oracle.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include "tests/cgal/surface_mesh.h"

namespace proveout::test {

std::string whatCgalFindsWrong(const TriangleMesh& mesh, Intersections intersections) {
    namespace pmp = CGAL::Polygon_mesh_processing;
    const auto solid = toSurfaceMesh(mesh);
    if (!solid)
        return "no polygon mesh";
    if (solid->number_of_vertices() != mesh.vertices.size() ||
        solid->number_of_faces() != mesh.triangles.size())
        return "vertices or triangles were lost";
    if (!CGAL::is_valid_polygon_mesh(*solid) || !CGAL::is_triangle_mesh(*solid))
        return "not valid";
    if (!CGAL::is_closed(*solid))
        return "not closed";
    if (!(CGAL::to_double(pmp::volume(*solid)) > 0))
        return "normals inwards";
    if (intersections == Intersections::look) {
        if (pmp::does_self_intersect(*solid))
            return "triangles intersect";
        // This requires a mesh without intersections; every part must be the outer boundary of its own
        // volume.
        if (!pmp::does_bound_a_volume(*solid))
            return "the parts do not bound a volume together";
    }
    return {};
}

} // namespace proveout::test
