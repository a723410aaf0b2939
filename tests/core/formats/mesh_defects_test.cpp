// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the counts of defects with a slow method that stores the facets of every edge.
#include "core/formats/mesh_defects.h"

#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

#include "tests/core/formats/meshes.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using test::randomSoup;
using test::tetrahedron;

void turnOver(std::array<std::uint32_t, 3>& triangle) {
    std::swap(triangle[1], triangle[2]);
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
    const auto shift = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& t : other.triangles)
        mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
}

/// Counts without `insideOut`.
MeshDefects countedSlowly(const TriangleMesh& mesh) {
    std::map<std::set<std::uint32_t>, int> facets;
    std::map<std::set<std::uint32_t>, std::vector<bool>> edges;
    for (const auto& t : mesh.triangles) {
        ++facets[{t[0], t[1], t[2]}];
        for (std::size_t k = 0; k < 3; ++k)
            edges[{t[k], t[(k + 1) % 3]}].push_back(t[k] < t[(k + 1) % 3]);
    }
    MeshDefects defects;
    for (const auto& [vertices, count] : facets)
        defects.duplicateFacets += static_cast<std::size_t>(count - 1);
    for (const auto& [vertices, ways] : edges) {
        defects.openEdges += ways.size() == 1 ? 1 : 0;
        defects.nonManifoldEdges += ways.size() > 2 ? 1 : 0;
        defects.flippedEdges += ways.size() == 2 && ways[0] == ways[1] ? 1 : 0;
    }
    return defects;
}

TEST(MeshDefects, AClosedMeshHasNone) {
    EXPECT_EQ(findDefects(tetrahedron()), MeshDefects());
    EXPECT_EQ(findDefects(tetrahedron(1e-3, Vec3(1e6, -1e6, 1e6))), MeshDefects());
    EXPECT_EQ(findDefects({}), MeshDefects());
}

TEST(MeshDefects, EachKindIsCounted) {
    TriangleMesh mesh = tetrahedron();
    mesh.triangles.pop_back();
    EXPECT_EQ(findDefects(mesh), (MeshDefects{.openEdges = 3}));

    mesh = tetrahedron();
    turnOver(mesh.triangles[1]);
    EXPECT_EQ(findDefects(mesh), (MeshDefects{.flippedEdges = 3}));

    mesh = tetrahedron();
    mesh.triangles.push_back({3, 1, 0}); // the second facet with the opposite orientation
    EXPECT_EQ(findDefects(mesh), (MeshDefects{.duplicateFacets = 1, .nonManifoldEdges = 3}));

    mesh = tetrahedron();
    for (auto& triangle : mesh.triangles)
        turnOver(triangle);
    EXPECT_EQ(findDefects(mesh), MeshDefects{.insideOut = true});
}

TEST(MeshDefects, ACavityIsNotInsideOutAndASmallHoleHidesNothing) {
    TriangleMesh cavity = tetrahedron(2, Vec3(1));
    for (auto& triangle : cavity.triangles)
        turnOver(triangle);
    TriangleMesh mesh = tetrahedron(10);
    append(mesh, cavity);
    EXPECT_EQ(findDefects(mesh), MeshDefects());

    for (int body = 0; body < 10; ++body)
        append(mesh, tetrahedron(10, Vec3(20 * body, 0, 50)));
    for (auto& triangle : mesh.triangles)
        turnOver(triangle);
    mesh.triangles.pop_back();
    EXPECT_EQ(findDefects(mesh), (MeshDefects{.openEdges = 3, .insideOut = true}));
}

TEST(MeshDefects, RandomSoupsAreCountedAsSlowly) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 200; ++round) {
        TriangleMesh mesh = randomSoup(1 + random() % 300, static_cast<unsigned>(random()));
        // Uses few vertices, so that edges and facets coincide.
        const auto most = static_cast<std::uint32_t>(3 + random() % 20);
        std::erase_if(mesh.triangles, [&](auto& t) {
            for (auto& vertex : t)
                vertex %= most;
            return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
        });
        MeshDefects defects = findDefects(mesh);
        defects.insideOut = false;
        ASSERT_EQ(defects, countedSlowly(mesh)) << "round " << round;
    }
}

/// The number of facets around one vertex is that of the whole mesh.
TEST(MeshDefects, AFanIsCountedInTime) {
    TriangleMesh mesh;
    const std::uint32_t count = 1'000'000;
    mesh.vertices.assign(count + 2, Vec3(0));
    for (std::uint32_t k = 1; k <= count; ++k)
        mesh.triangles.push_back({0, k, k + 1});
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(findDefects(mesh).openEdges, count + 2U);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

} // namespace
} // namespace proveout
