// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "tests/bench/peers/peer.h"

namespace proveout::bench {

namespace {

namespace Simplification = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Edge = boost::graph_traits<Mesh>::edge_descriptor;

/// Keeps the edges at the map's rim, so that the map remains covered.
struct OnRim {
    using key_type = Edge;
    using value_type = bool;
    using reference = bool;
    using category = boost::readable_property_map_tag;
    const Mesh* mesh;
    friend bool get(const OnRim& map, Edge edge) { return map.mesh->is_border(edge); }
};

PeerResult collapsed(const PeerMap& map, double /*allowance*/, std::size_t faces) {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> vertices;
    for (std::uint32_t i = 0; i < map.heights.size(); ++i) {
        const Vec3 p = pointOf(map, i);
        vertices.push_back(mesh.add_vertex({p.x, p.y, p.z}));
    }
    for (const LatticeTriangle& triangle : fullMesh(map))
        mesh.add_face(vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]);
    const OnRim rim{&mesh};
    const Simplification::Constrained_placement<Simplification::LindstromTurk_placement<Mesh>, OnRim>
        placement(rim);
    const double begin = cpuSeconds();
    Simplification::edge_collapse(mesh, Simplification::Count_stop_predicate<Mesh>(faces * 3 / 2),
                                  CGAL::parameters::edge_is_constrained_map(rim)
                                      .get_cost(Simplification::LindstromTurk_cost<Mesh>())
                                      .get_placement(placement)
                                      .filter(Simplification::Bounded_normal_change_filter<>()));
    PeerResult result{{}, {}, cpuSeconds() - begin};
    mesh.collect_garbage();
    for (const auto face : mesh.faces()) {
        std::array<Vec3, 3> facet;
        std::size_t corner = 0;
        for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
            const auto& p = mesh.point(vertex);
            facet[corner++] = {p.x(), p.y(), p.z()};
        }
        result.facets.push_back(facet);
    }
    return result;
}

} // namespace

Peers cgalPeers() {
    return {{"CGAL, Lindstrom-Turk", "our faces", collapsed}};
}

} // namespace proveout::bench
