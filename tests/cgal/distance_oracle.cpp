// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cgal/distance_oracle.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Kernel/global_functions_3.h> // the next header needs it but does not include it
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "tests/cgal/surface_mesh.h"

namespace proveout::test {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<SurfaceMesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

constexpr double kFarUp = 1e4; ///< mm; higher than every map of the tests

double infinity() {
    return std::numeric_limits<double>::infinity();
}

/// The triangles that are counter-clockwise seen from +Z, without walls and floor.
TriangleMesh facingUp(const TriangleMesh& solid) {
    TriangleMesh top{solid.vertices, {}};
    for (const auto& triangle : solid.triangles) {
        const Vec3& a = solid.vertices[triangle[0]];
        if (glm::cross(solid.vertices[triangle[1]] - a, solid.vertices[triangle[2]] - a).z > 0)
            top.triangles.push_back(triangle);
    }
    return top;
}

/// The height of a triangle's plane at a point.
double heightOver(const SurfaceMesh& mesh, SurfaceMesh::Face_index face, const Kernel::Point_3& point) {
    auto half = mesh.halfedge(face);
    const auto a = mesh.point(mesh.source(half));
    const auto b = mesh.point(mesh.target(half));
    const auto c = mesh.point(mesh.target(mesh.next(half)));
    const auto normal = CGAL::cross_product(b - a, c - a);
    return a.z() - (normal.x() * (point.x() - a.x()) + normal.y() * (point.y() - a.y())) / normal.z();
}

double verticalDistance(const Tree& tree, const SurfaceMesh& mesh, const Kernel::Point_3& point) {
    const Kernel::Segment_3 line({point.x(), point.y(), -kFarUp}, {point.x(), point.y(), kFarUp});
    std::vector<SurfaceMesh::Face_index> hit;
    tree.all_intersected_primitives(line, std::back_inserter(hit));
    double largest = hit.empty() ? infinity() : 0;
    for (const auto face : hit)
        largest = std::max(largest, std::abs(heightOver(mesh, face, point) - point.z()));
    return largest;
}

} // namespace

PointDistances distancesToTop(const std::vector<Vec3>& points, const TriangleMesh& solid) {
    const auto top = toSurfaceMesh(facingUp(solid));
    if (!top || top->is_empty())
        return {infinity(), infinity()};
    const Tree tree(top->faces().begin(), top->faces().end(), *top);
    std::vector<Kernel::Point_3> places;
    for (const Vec3& point : points)
        places.emplace_back(point.x, point.y, point.z);
    PointDistances distances;
    for (const auto& place : places)
        distances.vertical = std::max(distances.vertical, verticalDistance(tree, *top, place));
    distances.nearest = pmp::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(places, *top);
    return distances;
}

std::vector<SidedDistance> sidedDistances(const std::vector<Vec3>& points, const TriangleMesh& mesh) {
    const auto surface = toSurfaceMesh(mesh);
    if (!surface || surface->is_empty())
        return {};
    const Tree tree(surface->faces().begin(), surface->faces().end(), *surface);
    const CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel> side(*surface);
    std::vector<SidedDistance> distances;
    for (const Vec3& point : points) {
        const Kernel::Point_3 place(point.x, point.y, point.z);
        distances.push_back({std::sqrt(tree.squared_distance(place)), side(place) == CGAL::ON_BOUNDED_SIDE});
    }
    return distances;
}

double farthestFrom(const TriangleMesh& mesh, const std::vector<Vec3>& points) {
    const auto surface = toSurfaceMesh(mesh);
    if (!surface || surface->is_empty())
        return infinity();
    std::vector<Kernel::Point_3> places;
    places.reserve(points.size());
    for (const Vec3& point : points)
        places.emplace_back(point.x, point.y, point.z);
    return pmp::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(places, *surface);
}

double symmetricHausdorff(const TriangleMesh& a, const TriangleMesh& b, double bound) {
    const auto first = toSurfaceMesh(a);
    const auto second = toSurfaceMesh(b);
    if (!first || !second)
        return infinity();
    return pmp::bounded_error_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(*first, *second, bound);
}

bool isHausdorffLarger(const TriangleMesh& a, const TriangleMesh& b, double distance, double error) {
    const auto first = toSurfaceMesh(a);
    const auto second = toSurfaceMesh(b);
    return !first || !second ||
           pmp::is_Hausdorff_distance_larger<CGAL::Sequential_tag>(*first, *second, distance, error);
}

} // namespace proveout::test
