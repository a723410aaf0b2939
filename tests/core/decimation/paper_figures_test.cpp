// SPDX-License-Identifier: GPL-3.0-or-later
// One test for each figure of the paper that shows a mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "core/decimation/lee/lee_decimator.h"
#include "core/decimation/lee/region_half_edges.h"
#include "core/decimation/lee/vertex_error.h"
#include "core/decimation/regions/random_order.h"
#include "tests/core/decimation/maps.h"
#include "tests/core/decimation/topology.h"

namespace proveout {
namespace {

/// A mesh of cellsX × cellsY cells whose south-west cell has the diagonal "/".
RegionHalfEdges flatMesh(int cellsX, int cellsY) {
    RegionHalfEdges mesh;
    const IndexRect rect{0, 0, cellsX + 1, cellsY + 1};
    mesh.build(rect, std::vector<float>(static_cast<std::size_t>(rect.width() * rect.height()), 0.0F));
    return mesh;
}

std::size_t spokeTo(const Star& star, OpenMesh::VertexHandle tip) {
    for (std::size_t k = 0; k < star.spokes.size(); ++k)
        if (star.spokes[k].tip == tip)
            return k;
    ADD_FAILURE() << "no edge to vertex " << tip.idx();
    return 0;
}

std::vector<LatticeTriangle> facesOf(const RegionHalfEdges& mesh) {
    std::vector<LatticeTriangle> faces;
    mesh.forEachFace([&](auto a, auto b, auto c) {
        faces.push_back({static_cast<std::uint32_t>(a.idx()), static_cast<std::uint32_t>(b.idx()),
                         static_cast<std::uint32_t>(c.idx())});
    });
    return faces;
}

std::set<LatticeTriangle> asSet(std::vector<LatticeTriangle> faces) {
    for (LatticeTriangle& t : faces)
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return {faces.begin(), faces.end()};
}

// The middle vertex of 2 × 2 cells has eight neighbours. Collapsing it into the corner would make the three
// vertices of the face on the southern edge collinear.
TEST(Figure4a, collapseThatDegeneratesAFaceIsRefused) {
    RegionHalfEdges mesh = flatMesh(2, 2);
    const Star& star = mesh.star(mesh.vertex(1, 1));
    ASSERT_EQ(star.spokes.size(), 8U);
    for (const auto& [i, j] : {std::pair{0, 0}, {2, 0}, {0, 2}, {2, 2}})
        EXPECT_FALSE(mesh.isCollapseValid(star, spokeTo(star, mesh.vertex(i, j))));
    for (const auto& [i, j] : {std::pair{1, 0}, {0, 1}, {2, 1}, {1, 2}})
        EXPECT_TRUE(mesh.isCollapseValid(star, spokeTo(star, mesh.vertex(i, j))));
}

// After a few collapses some stars are concave; from beyond such a bend, a face would be flipped. All stars
// on the way are examined, and all their edges tried.
TEST(Figure4b, collapseThatFlipsAFaceIsRefused) {
    RegionHalfEdges mesh = flatMesh(8, 8);
    constexpr unsigned kSeed = 4;
    SCOPED_TRACE(kSeed);
    std::mt19937 random(kSeed);
    std::size_t flipped = 0;
    std::size_t sound = 0;
    for (int step = 0; step < 1200; ++step) {
        if (step % 60 == 0)
            mesh = flatMesh(8, 8);
        const OpenMesh::VertexHandle vertex =
            mesh.vertex(1 + static_cast<int>(random() % 7), 1 + static_cast<int>(random() % 7));
        if (mesh.mesh().status(vertex).deleted())
            continue;
        const Star& star = mesh.star(vertex);
        for (std::size_t target = 0; target < star.spokes.size(); ++target) {
            bool flips = false; // from the areas of the faces, computed independently
            for (std::size_t k = 0; k < star.spokes.size(); ++k) {
                const std::size_t next = (k + 1) % star.spokes.size();
                if (k == target || next == target)
                    continue;
                const auto& p = star.spokes[target].offset;
                const auto& q = star.spokes[k].offset;
                const auto& r = star.spokes[next].offset;
                flips |= (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) < 0;
            }
            flipped += flips ? 1 : 0;
            const bool valid = mesh.isCollapseValid(star, target);
            sound += valid ? 1 : 0;
            EXPECT_FALSE(flips && valid);
        }
        const std::size_t target = random() % star.spokes.size();
        if (mesh.isCollapseValid(star, target))
            mesh.collapse(star, target);
        test::expectCoversMap(9, 9, facesOf(mesh));
        if (HasFailure())
            return;
    }
    EXPECT_GT(flipped, 100U) << "the test must meet flipped faces";
    EXPECT_GT(sound, 100U);
}

// Fig. 5 is the mesh of 2 × 2 cells: edges 1 … 16, vertices a … i, faces A … H.
TEST(Figure5, anInteriorCollapseTakesTwoFacesThreeEdgesAndAVertex) {
    RegionHalfEdges mesh = flatMesh(2, 2);
    ASSERT_EQ(mesh.faceCount(), 8U);
    ASSERT_EQ(mesh.edgeCount(), 16U);
    ASSERT_EQ(mesh.vertexCount(), 9U);
    const Star& star = mesh.star(mesh.vertex(1, 1));
    mesh.collapse(star, spokeTo(star, mesh.vertex(2, 1)));
    EXPECT_EQ(mesh.faceCount(), 6U);
    EXPECT_EQ(mesh.edgeCount(), 13U);
    EXPECT_EQ(mesh.vertexCount(), 8U);
    test::expectCoversMap(3, 3, facesOf(mesh));
}

TEST(Figure5, eachKefTakesAFaceAndAnEdgeAndTheKevAnEdgeAndAVertex) {
    RegionHalfEdges region = flatMesh(2, 2);
    HalfEdgeMesh mesh = region.mesh();
    const auto count = [](auto begin, auto end) { return std::distance(begin, end); };
    const auto alive = [&] {
        return std::array{count(mesh.faces_sbegin(), mesh.faces_end()),
                          count(mesh.edges_sbegin(), mesh.edges_end()),
                          count(mesh.vertices_sbegin(), mesh.vertices_end())};
    };
    const Star& star = region.star(region.vertex(1, 1));
    const OpenMesh::HalfedgeHandle out = star.spokes[spokeTo(star, region.vertex(2, 1))].out;
    const OpenMesh::HalfedgeHandle back = mesh.opposite_halfedge_handle(out);
    killEdgeAndFace(mesh, mesh.prev_halfedge_handle(out));
    EXPECT_EQ(alive(), (std::array<std::ptrdiff_t, 3>{7, 15, 9}));
    killEdgeAndFace(mesh, mesh.next_halfedge_handle(back));
    EXPECT_EQ(alive(), (std::array<std::ptrdiff_t, 3>{6, 14, 9}));
    killEdgeAndVertex(mesh, out);
    EXPECT_EQ(alive(), (std::array<std::ptrdiff_t, 3>{6, 13, 8}));
}

// Fig. 6 is a border vertex between two cells: faces A … D.
TEST(Figure6, aBorderCollapseTakesOneFaceTwoEdgesAndAVertex) {
    RegionHalfEdges mesh = flatMesh(2, 1);
    ASSERT_EQ(mesh.faceCount(), 4U);
    ASSERT_EQ(mesh.edgeCount(), 9U);
    ASSERT_EQ(mesh.vertexCount(), 6U);
    const Star& star = mesh.star(mesh.vertex(1, 0));
    EXPECT_FALSE(star.closed);
    mesh.collapse(star, spokeTo(star, mesh.vertex(0, 0)));
    EXPECT_EQ(mesh.faceCount(), 3U);
    EXPECT_EQ(mesh.edgeCount(), 7U);
    EXPECT_EQ(mesh.vertexCount(), 5U);
}

TEST(Figure6, onlyTheTwoBorderEdgesAreCandidatesAndCornersStay) {
    // Cells are three times as wide as deep, so that the shortest edges at the southern and northern borders
    // point inwards: the border rule must not collapse along them.
    DecimationParameters parameters = test::leeParameters();
    parameters.borders = BorderRule::paper;
    parameters.certify = false;
    parameters.allowance = 100;
    const RegionGrid grid(9, 9, 8);
    std::vector<float> heights(81, 0.0F);
    LeeDecimator decimator;
    const RegionMesh mesh = decimator.decimate(grid, {grid.points(0), 3, 1, heights}, {}, 7, parameters);
    test::expectCoversMap(9, 9, mesh.triangles); // moving a border vertex leaves a notch
    std::set<std::uint32_t> used;
    for (const LatticeTriangle& t : mesh.triangles)
        used.insert(t.begin(), t.end());
    for (const std::uint32_t corner : {0U, 8U, 72U, 80U})
        EXPECT_TRUE(used.contains(corner));
    EXPECT_LT(used.size(), 12U);
}

/// Removes all removable vertices of a flat mesh in the given sequence, and counts the neighbours examined,
/// which determine the time of a removal.
std::size_t neighboursExamined(RemovalOrder order, int cells) {
    RegionHalfEdges mesh = flatMesh(cells, cells);
    std::vector<std::uint32_t> vertices;
    for (int j = 1; j < cells; ++j)
        for (int i = 1; i < cells; ++i)
            vertices.push_back(static_cast<std::uint32_t>(mesh.vertex(i, j).idx()));
    arrange(vertices, order, 1);
    std::size_t examined = 0;
    for (const std::uint32_t vertex : vertices) {
        const Star& star = mesh.star(OpenMesh::VertexHandle(static_cast<int>(vertex)));
        examined += star.spokes.size();
        std::vector<std::size_t> targets(star.spokes.size());
        std::iota(targets.begin(), targets.end(), std::size_t{0});
        std::stable_sort(targets.begin(), targets.end(), [&](std::size_t a, std::size_t b) {
            return star.spokes[a].offset.sqrnorm() < star.spokes[b].offset.sqrnorm();
        });
        for (const std::size_t target : targets) {
            if (mesh.isCollapseValid(star, target)) {
                mesh.collapse(star, target);
                break;
            }
        }
    }
    return examined;
}

// "If vertices are examined and deleted sequentially, the number of the faces and vertices adjacent to a
// vertex to be examined will increase."
TEST(Figure7, randomOrderExaminesFewerNeighboursThanSequential) {
    const std::size_t sequential = neighboursExamined(RemovalOrder::sequential, 64);
    const std::size_t random = neighboursExamined(RemovalOrder::random, 64);
    RecordProperty("neighboursSequential", static_cast<int>(sequential));
    RecordProperty("neighboursRandom", static_cast<int>(random));
    EXPECT_LT(random, sequential);
}

TEST(AveragePlane, isTheAreaWeightedPlaneOfThePaper) {
    constexpr unsigned kSeed = 11;
    SCOPED_TRACE(kSeed);
    std::mt19937 random(kSeed);
    RegionHalfEdges mesh;
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<float> heights(25);
        for (float& z : heights)
            z = static_cast<float>(random() % 1000) / 100.0F - 10;
        mesh.build({0, 0, 5, 5}, heights);
        const Star& star = mesh.star(mesh.vertex(2, 2));
        const double hx = 0.5;
        const double hy = 0.7;
        // Section 4.2.1, implemented literally.
        const Vec3 v{2 * hx, 2 * hy, double{heights[12]}};
        Vec3 sumNormals{0};
        Vec3 sumCentres{0};
        double sumAreas = 0;
        for (std::size_t k = 0; k < star.spokes.size(); ++k) {
            const auto at = [&](std::size_t spoke) {
                const int tip = star.spokes[spoke % star.spokes.size()].tip.idx();
                return Vec3{tip % 5 * hx, tip / 5 * hy, double{heights[static_cast<std::size_t>(tip)]}};
            };
            const Vec3 a = at(k);
            const Vec3 b = at(k + 1);
            const Vec3 cross = glm::cross(a - v, b - v);
            const double area = glm::length(cross) / 2;
            sumNormals += area * glm::normalize(cross);
            sumCentres += area * (v + a + b) / 3.0;
            sumAreas += area;
        }
        const Vec3 n = glm::normalize(sumNormals / sumAreas);
        const double d = std::abs(glm::dot(n, v - sumCentres / sumAreas));
        EXPECT_NEAR(averagePlaneDistance(star, hx, hy), d, 1e-12);
    }
}

/// Compares our collapse with that of OpenMesh, for random collapses that OpenMesh allows, whether
/// geometrically valid or not.
TEST(EulerOperators, doWhatTheCollapseOfOpenMeshDoes) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        RegionHalfEdges region = flatMesh(5, 4);
        HalfEdgeMesh ours = region.mesh();
        HalfEdgeMesh theirs = region.mesh();
        for (int step = 0; step < 200; ++step) {
            const OpenMesh::HalfedgeHandle out(static_cast<int>(random() % ours.n_halfedges()));
            if (theirs.status(theirs.edge_handle(out)).deleted() || !theirs.is_collapse_ok(out))
                continue;
            theirs.collapse(out);
            collapseEdge(ours, out);
            for (const auto v : theirs.all_vertices()) {
                ASSERT_EQ(ours.status(v).deleted(), theirs.status(v).deleted());
                if (ours.status(v).deleted())
                    continue;
                ASSERT_EQ(ours.is_boundary(v), theirs.is_boundary(v));
                std::set<int> ourRing;
                std::set<int> theirRing;
                for (const auto w : ours.vv_range(v))
                    ourRing.insert(w.idx());
                for (const auto w : theirs.vv_range(v))
                    theirRing.insert(w.idx());
                ASSERT_EQ(ourRing, theirRing);
            }
            const auto faces = [](const HalfEdgeMesh& mesh) {
                std::vector<LatticeTriangle> all;
                for (const auto f : mesh.faces()) {
                    LatticeTriangle t{};
                    std::size_t k = 0;
                    for (const auto v : mesh.fv_range(f))
                        t.at(k++) = static_cast<std::uint32_t>(v.idx());
                    all.push_back(t);
                }
                return asSet(all);
            };
            ASSERT_EQ(faces(ours), faces(theirs));
        }
    }
}

} // namespace
} // namespace proveout
