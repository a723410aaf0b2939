// SPDX-License-Identifier: GPL-3.0-or-later
// The top of a mesh, compared with the map of the same mesh, which does not need an index.
#include "core/zmap/mesh_top.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <thread>
#include <vector>

#include "tests/core/zmap/mesh_bodies.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using Random = std::mt19937;

double between(Random& random, double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
}

/// Triangles of any size and slope, upright ones and slivers among them, over one another; not closed.
StockMesh randomTriangles(Random& random, int count) {
    StockMesh mesh;
    const auto corner = [&] {
        return Vec3(between(random, -20, 20), between(random, -15, 15), between(random, 0, 9));
    };
    for (int k = 0; k < count; ++k) {
        const double size = std::pow(10, between(random, -3, 0));
        const Vec3 a = corner();
        std::array<Vec3, 3> c{a, glm::mix(a, corner(), size), glm::mix(a, corner(), size)};
        if (random() % 8 == 0)
            c[2] = {c[1].x, c[1].y, c[2].z};
        if (random() % 8 == 0)
            c[2] = glm::mix(c[0], c[1], 0.5) + Vec3(1e-7, -1e-7, 3);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), c.begin(), c.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// Of all points.
void expectHeightsOfTheMap(const StockBody& body, const StockBox& stock, double spacing, double rounding) {
    const auto top = body.top(stock);
    ASSERT_NE(top, nullptr);
    EXPECT_TRUE(top->knowsWalls());
    const UncutStock uncut = body.uncut(stock, makeGrid(stock, spacing).value());
    const ZMapSnapshot map = uncut.zmap.snapshot();
    int material = 0;
    for (int j = 0; j < map.grid().ny; ++j)
        for (int i = 0; i < map.grid().nx; ++i) {
            const double height = top->height({map.grid().x(i), map.grid().y(j)});
            ASSERT_NEAR(std::clamp(static_cast<float>(height), map.floor(), 0.0F), map.height(i, j), rounding)
                << i << ' ' << j;
            material += map.height(i, j) > map.floor() ? 1 : 0;
        }
    EXPECT_GT(material, 100);
}

TEST(MeshTop, IsAsHighAsTheMapAtItsPoints) {
    const std::uint32_t first = randomSeed();
    for (int k = 0; k < roundsOf(40); ++k) {
        const std::uint32_t seed = first + static_cast<std::uint32_t>(k);
        SCOPED_TRACE(fmt::format("seed {}", seed));
        Random random(seed);
        StockMesh mesh = k % 2 == 0 ? starBody({3, -7, 20}, 7, 9, [&] { return between(random, 4, 10); })
                                    : randomTriangles(random, 1 << random() % 10);
        addBox(mesh, {-4, -6, 0}, {5, 3, 8}); // walls at points
        const auto body = meshStock(std::move(mesh)).value();
        expectHeightsOfTheMap(*body, body->box(), 0.25, 0);
        StockBox moved = body->box();
        moved.corner += Vec3(1024, -512, 3);
        expectHeightsOfTheMap(*body, moved, 0.25, 1e-5);
    }
}

TEST(MeshTop, TurnedWallsAreThoseOfTheMap) {
    for (const double degrees : {0.0, 17.0, 45.0}) {
        StockMesh mesh;
        addBox(mesh, {-10, -8, 0}, {10, 8, 5});
        turn(mesh, degrees);
        const auto body = meshStock(std::move(mesh)).value();
        expectHeightsOfTheMap(*body, body->box(), 0.5, 0);
    }
}

TEST(MeshTop, ItsBoundHoldsAndIsNear) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Random random(seed);
    StockMesh mesh = starBody({3, -7, 20}, 9, 11, [&] { return between(random, 4, 10); });
    addBox(mesh, {5, 0, 2}, {20, 9, 14});
    turn(mesh, 17);
    const auto body = meshStock(std::move(mesh)).value();
    const StockBox box = body->box();
    const auto top = body->top(box);
    int absent = 0;
    int near = 0;
    for (int k = 0; k < 20'000; ++k) {
        const Vec2 lo =
            Vec2(box.corner) + Vec2(between(random, -1, box.width), between(random, -1, box.depth));
        const Vec2 hi = lo + std::pow(10, between(random, -4, 0.5)) * Vec2(between(random, 0, 1), 1);
        const double bound = top->highest(lo, hi);
        double highest = StockTop::kAbsent;
        for (const double u : {0.0, 0.3, 0.5, 1.0})
            for (const double v : {0.0, 0.5, 0.8, 1.0})
                highest = std::max(highest, top->height(lo + (hi - lo) * Vec2(u, v)));
        ASSERT_LE(highest, bound + 1e-9);
        absent += bound == StockTop::kAbsent ? 1 : 0;
        near += bound > StockTop::kAbsent && bound - highest < 0.1 ? 1 : 0;
    }
    EXPECT_GT(absent, 2000);
    EXPECT_GT(near, 5000);
}

TEST(MeshTop, IsTheSameOnAllThreads) {
    const auto body = meshStock(starBody({0, 0, 0}, 40, 80, [] { return 9.0; })).value();
    std::vector<double> heights(4);
    std::vector<std::thread> threads;
    for (double& height : heights)
        threads.emplace_back([&] { height = body->top(body->box())->height({1.25, 2.5}); });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_NEAR(heights[0], std::sqrt(81 - 1.25 * 1.25 - 2.5 * 2.5) - 9, 0.01);
    EXPECT_EQ(std::ranges::count(heights, heights[0]), 4);
}

/// A fan of so many long triangles that an index does not help.
TEST(MeshTop, IsNoneOfAMeshThatWouldBeSlow) {
    EXPECT_NE(meshStock(roundBody(15, 10, 1440)).value()->top({{0, 0, 0}, 30, 30, 10}), nullptr);
    EXPECT_EQ(meshStock(roundBody(15, 10, 40'000)).value()->top({{0, 0, 0}, 30, 30, 10}), nullptr);
}

} // namespace
} // namespace proveout
