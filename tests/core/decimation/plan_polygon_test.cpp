// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of polygons, checked by what any triangulation has: their number, their sides and their areas.
#include "core/decimation/solid/plan_polygon.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include "tests/random_seed.h"

namespace proveout {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
}

struct Polygon {
    std::vector<Vec2> points;
    std::vector<PlanLoop> loops;

    void add(const std::vector<Vec2>& places) {
        PlanLoop loop;
        for (const Vec2& place : places) {
            loop.push_back(static_cast<std::uint32_t>(points.size()));
            points.push_back(place);
        }
        loops.push_back(std::move(loop));
    }
};

void expectTriangulated(const Polygon& polygon) {
    const auto triangles = triangulatePolygon(polygon.points, polygon.loops);
    ASSERT_TRUE(triangles.has_value());
    std::size_t expected = polygon.points.size() + 2 * polygon.loops.size() - 4;
    for (const PlanLoop& loop : polygon.loops)
        expected -= loop.size() == 1 ? 1U : 0U;
    EXPECT_EQ(triangles->size(), expected);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const auto& triangle : *triangles) {
        EXPECT_GT(turn(polygon.points[triangle[0]], polygon.points[triangle[1]], polygon.points[triangle[2]]),
                  0);
        for (std::size_t k = 0; k < 3; ++k)
            ++sides[{triangle[k], triangle[(k + 1) % 3]}];
    }
    std::size_t open = 0;
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count, 1);
        open += sides.contains({side.second, side.first}) ? 0U : 1U;
    }
    for (const PlanLoop& loop : polygon.loops) {
        for (std::size_t k = 0; loop.size() > 1 && k < loop.size(); ++k) {
            EXPECT_TRUE(sides.contains({loop[k], loop[(k + 1) % loop.size()]}));
            --open;
        }
    }
    EXPECT_EQ(open, 0U);
}

/// Around a centre, with random radii: never crosses itself.
std::vector<Vec2> star(Random& random, const Vec2& centre, double least, double most, int corners,
                       bool isHole) {
    std::vector<Vec2> places;
    for (int k = 0; k < corners; ++k) {
        const double angle = (isHole ? -1 : 1) * 2 * std::numbers::pi * k / corners;
        places.push_back(centre + uniform(random, least, most) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return places;
}

TEST(PlanPolygon, OfRandomStarsWithHolesAndPoints) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Random random(seed);
    for (int round = 0; round < roundsOf(60); ++round) {
        Polygon polygon;
        polygon.add(star(random, {50, 50}, 60, 90, 3 + static_cast<int>(random() % 60), false));
        for (int i = 0; i < 5; ++i) {
            for (int j = 0; j < 5; ++j) {
                const Vec2 centre(32 + 9.0 * i, 32 + 9.0 * j);
                if (glm::distance(centre, {50, 50}) > 24)
                    continue; // a triangle may be the outline
                if (random() % 3 == 0)
                    polygon.add(star(random, centre, 0.5, 4.4, 3 + static_cast<int>(random() % 20), true));
                else if (random() % 2 == 0)
                    polygon.add({centre});
            }
        }
        SCOPED_TRACE(fmt::format("round {}", round));
        expectTriangulated(polygon);
    }
}

/// Corners on straight lines, equal heights, and holes beside each other as on a plate with a grid of holes.
TEST(PlanPolygon, OfAPlateWithARowOfSquareHoles) {
    Polygon polygon;
    polygon.add({{0, 0}, {5, 0}, {10, 0}, {20, 0}, {20, 10}, {20, 20}, {10, 20}, {0, 20}, {0, 10}});
    for (double x = 2; x < 18; x += 4) {
        for (double y = 2; y < 18; y += 4)
            polygon.add({{x, y}, {x, y + 2}, {x + 1, y + 2}, {x + 2, y + 2}, {x + 2, y}});
    }
    expectTriangulated(polygon);
}

TEST(PlanPolygon, OfASpiral) {
    Polygon polygon;
    std::vector<Vec2> places;
    const auto at = [](double turns, double radius) {
        return radius * Vec2(std::cos(2 * std::numbers::pi * turns), std::sin(2 * std::numbers::pi * turns));
    };
    constexpr int kSteps = 200;
    for (int k = 0; k <= kSteps; ++k)
        places.push_back(at(5.0 * k / kSteps, 10 + 2.0 * k / kSteps * 25));
    for (int k = kSteps; k >= 0; --k)
        places.push_back(at(5.0 * k / kSteps, 5 + 2.0 * k / kSteps * 25));
    polygon.add(places);
    expectTriangulated(polygon);
}

TEST(PlanPolygon, IsNothingWhereLinesCrossOrTurnTheOtherWay) {
    Polygon clockwise;
    clockwise.add({{0, 0}, {0, 1}, {1, 0}});
    EXPECT_FALSE(triangulatePolygon(clockwise.points, clockwise.loops).has_value());
    Polygon eight;
    eight.add({{0, 0}, {10, 0}, {0, 8}, {10, 10}});
    EXPECT_FALSE(triangulatePolygon(eight.points, eight.loops).has_value());
    Polygon outside;
    outside.add({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    outside.add({{20, 5}, {20, 6}, {21, 5}});
    EXPECT_FALSE(triangulatePolygon(outside.points, outside.loops).has_value());
}

} // namespace
} // namespace proveout
