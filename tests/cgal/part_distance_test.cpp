// SPDX-License-Identifier: GPL-3.0-or-later
// Distances from a part and the sides of its surface, compared with CGAL's tree of boxes and its test of
// rays.
#include "core/part/part_distance.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "tests/cgal/distance_oracle.h"
#include "tests/core/part/part_meshes.h"
#include "tests/random_seed.h"

namespace proveout::test {
namespace {

/// A sphere with hills and valleys, which no line from its middle meets twice; some facets are slivers.
Mesh hillyMesh(Random& random) {
    Mesh mesh = sphereMesh(10, 8 + 2 * static_cast<std::uint32_t>(random() % 40));
    const double height = uniform(random, 0, 0.6);
    for (Vec3& vertex : mesh.vertices)
        vertex *= 1 + uniform(random, -height, height);
    const Vec3 stretch(1, uniform(random, 0.05, 1), uniform(random, 0.05, 1));
    const Vec3 place(uniform(random, -500, 500), uniform(random, -500, 500), uniform(random, -500, 500));
    for (Vec3& vertex : mesh.vertices)
        vertex = vertex * stretch + place;
    return mesh;
}

/// Two closed shells with little between them.
Mesh shellsMesh(Random& random) {
    Mesh mesh = boxMesh({0, 0, 0}, {10, 10, 10});
    const double gap = std::pow(10, uniform(random, -4, 0));
    const Mesh other = boxMesh({10 + gap, -5, -5}, {20, 15, 15});
    for (const PartDistance::Facet& facet : other.facets)
        mesh.facets.push_back({facet[0] + 8, facet[1] + 8, facet[2] + 8});
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    return mesh;
}

/// In and around a mesh, and near its facets.
std::vector<Vec3> pointsNear(const Mesh& mesh, Random& random, int count) {
    std::vector<Vec3> points;
    for (int k = 0; k < count; ++k) {
        const auto& [a, b, c] = mesh.facets[random() % mesh.facets.size()];
        const double u = uniform(random, 0, 1);
        const double v = uniform(random, 0, 1 - u);
        const Vec3 on = mesh.vertices[a] * (1 - u - v) + mesh.vertices[b] * u + mesh.vertices[c] * v;
        points.push_back(on + randomDirection(random) * std::pow(10, uniform(random, -3, 1.5)));
    }
    return points;
}

TEST(PartDistance, IsThatOfCgalOnRandomParts) {
    const std::uint32_t first = randomSeed();
    for (std::uint32_t round = 0; round < 40; ++round) {
        SCOPED_TRACE("seed " + std::to_string(first + round));
        Random random(first + round);
        const Mesh mesh = round % 4 == 0 ? shellsMesh(random) : hillyMesh(random);
        const PartDistance part(mesh.vertices, mesh.facets);
        const std::vector<Vec3> points = pointsNear(mesh, random, 500);
        const std::vector<SidedDistance> expected = sidedDistances(points, {mesh.vertices, mesh.facets});
        const auto places = part.at(points);
        for (std::size_t k = 0; k < points.size(); ++k) {
            ASSERT_TRUE(places[k].has_value());
            EXPECT_NEAR(std::abs(places[k]->distance), expected[k].distance, 1e-9);
            EXPECT_NEAR(glm::distance(places[k]->nearest, points[k]), expected[k].distance, 1e-9);
            if (expected[k].distance > 1e-7) {
                EXPECT_TRUE(places[k]->hasSide);
                EXPECT_EQ(places[k]->distance < 0, expected[k].isInside) << expected[k].distance;
            }
        }
    }
}

} // namespace
} // namespace proveout::test
