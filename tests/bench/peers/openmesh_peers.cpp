// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wextra"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#pragma GCC diagnostic pop

#include "tests/bench/peers/peer.h"

namespace proveout::bench {

namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
using Decimater = OpenMesh::Decimater::DecimaterT<Mesh>;

Mesh meshOf(const PeerMap& map) {
    Mesh mesh;
    mesh.request_face_normals();
    for (std::uint32_t i = 0; i < map.heights.size(); ++i) {
        const Vec3 p = pointOf(map, i);
        mesh.add_vertex({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    }
    for (const LatticeTriangle& triangle : fullMesh(map))
        mesh.add_face(mesh.vertex_handle(triangle[0]), mesh.vertex_handle(triangle[1]),
                      mesh.vertex_handle(triangle[2]));
    mesh.update_normals();
    return mesh;
}

/// Without its corners the map would not be covered.
void lockCorners(Mesh& mesh, const PeerMap& map) {
    mesh.request_vertex_status();
    for (const int j : {0, map.ny - 1})
        for (const int i : {0, map.nx - 1})
            mesh.status(mesh.vertex_handle(static_cast<unsigned>(j * map.nx + i))).set_locked(true);
}

PeerResult decimated(const PeerMap& map, double allowance, bool hausdorff) {
    Mesh mesh = meshOf(map);
    const double begin = cpuSeconds();
    Decimater decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
    OpenMesh::Decimater::ModHausdorffT<Mesh>::Handle distance;
    decimater.add(quadric);
    decimater.module(quadric).set_max_err(allowance * allowance);
    decimater.add(flipping);
    decimater.module(flipping).set_max_normal_deviation(89);
    if (hausdorff) {
        decimater.add(distance);
        decimater.module(distance).set_tolerance(static_cast<float>(allowance));
    }
    decimater.initialize();
    lockCorners(mesh, map);
    decimater.decimate();
    mesh.garbage_collection();
    PeerResult result{{}, {}, cpuSeconds() - begin};
    for (const auto face : mesh.faces()) {
        LatticeTriangle triangle{};
        std::size_t corner = 0;
        for (const auto vertex : mesh.fv_range(face))
            triangle[corner++] = indexOf(map, static_cast<double>(mesh.point(vertex)[0]),
                                         static_cast<double>(mesh.point(vertex)[1]));
        result.triangles.push_back(triangle);
    }
    return result;
}

} // namespace

Peers openMeshPeers() {
    return {
        {"OpenMesh, ModQuadric", "ε²",
         [](const PeerMap& map, double allowance, std::size_t) { return decimated(map, allowance, false); }},
        {"OpenMesh, ModQuadric and ModHausdorff", "ε",
         [](const PeerMap& map, double allowance, std::size_t) { return decimated(map, allowance, true); }}};
}

} // namespace proveout::bench
