// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/part_distance.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "tests/core/part/part_meshes.h"

namespace proveout::test {
namespace {

TEST(PartDistance, OfABoxIsThatOfItsFormula) {
    const Mesh box = boxMesh({-1, -2, -3}, {4, 5, 6});
    const PartDistance part(box.vertices, box.facets);
    Random random(randomSeed());
    for (int k = 0; k < 20'000; ++k) {
        const Vec3 point(uniform(random, -4, 8), uniform(random, -5, 9), uniform(random, -6, 10));
        const Vec3 away = glm::max(glm::max(Vec3(-1, -2, -3) - point, point - Vec3(4, 5, 6)), Vec3(0));
        const Vec3 inside = glm::min(point - Vec3(-1, -2, -3), Vec3(4, 5, 6) - point);
        const double depth = std::min({inside.x, inside.y, inside.z});
        const auto place = part.at(point);
        ASSERT_TRUE(place.has_value());
        EXPECT_NEAR(place->distance, depth > 0 ? -depth : glm::length(away), 1e-12);
        EXPECT_TRUE(place->hasSide);
    }
}

TEST(PartDistance, OfASphereIsThatOfItsChords) {
    const Mesh sphere = sphereMesh(10, 200);
    const PartDistance part(sphere.vertices, sphere.facets);
    const double sagitta = 10 * (1 - std::cos(std::numbers::pi / 200));
    Random random(randomSeed());
    for (int k = 0; k < 20'000; ++k) {
        const Vec3 point = randomDirection(random) * uniform(random, 0, 20);
        const auto place = part.at(point);
        EXPECT_NEAR(place->distance, glm::length(point) - 10, 2.1 * sagitta);
        EXPECT_TRUE(place->hasSide);
    }
}

TEST(PartDistance, OfManyPointsIsThatOfEach) {
    const Mesh sphere = sphereMesh(10, 40);
    const PartDistance part(sphere.vertices, sphere.facets);
    Random random(randomSeed());
    std::vector<Vec3> points;
    for (int k = 0; k < 5000; ++k)
        points.push_back(k % 7 == 0 ? Vec3(uniform(random, -30, 30), uniform(random, -30, 30), 3)
                                    : points.back() + randomDirection(random) * 0.1);
    const auto places = part.at(points);
    ASSERT_EQ(places.size(), points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto one = part.at(points[k]);
        EXPECT_EQ(places[k]->distance, one->distance);
        EXPECT_EQ(places[k]->facet, one->facet);
    }
}

TEST(PartDistance, AtAnOpenEdgeHasNoSide) {
    Mesh box = boxMesh({0, 0, 0}, {2, 2, 2});
    std::erase_if(box.facets, [&](const PartDistance::Facet& facet) { // no lid
        return box.vertices[facet[0]].z == 2 && box.vertices[facet[1]].z == 2 &&
               box.vertices[facet[2]].z == 2;
    });
    const PartDistance part(box.vertices, box.facets);
    EXPECT_FALSE(part.at({1, -1, 4})->hasSide);
    EXPECT_TRUE(part.at({1, 1, 0.5})->hasSide);
    EXPECT_NEAR(part.at({1, 1, 0.5})->distance, -0.5, 1e-12);
    EXPECT_FALSE(PartDistance({}, {}).at({0, 0, 0}).has_value());
}

TEST(PartDistance, OfFewFacetsIsKnown) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<PartDistance::Facet> facets{{0, 1, 2}};
    const PartDistance part(vertices, facets);
    EXPECT_NEAR(part.at({0.25, 0.25, 2})->distance, 2, 1e-15);
    EXPECT_NEAR(part.at({0.25, 0.25, -2})->distance, -2, 1e-15);
}

} // namespace
} // namespace proveout::test
