// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/deviation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "core/part/islands.h"
#include "tests/core/part/part_meshes.h"

namespace proveout::test {
namespace {

constexpr StockBox kStock{{-20, -20, 0}, 40, 40, 30};

ZMapSnapshot mapOf(const StockBox& stock, double spacing,
                   const std::function<double(const Vec2&)>& heightAt) {
    const Grid grid = *makeGrid(stock, spacing);
    ZMap zmap(stock, grid);
    for (std::size_t index = 0; index < zmap.tileCount(); ++index) {
        const IndexRect rect = zmap.tileRect(index);
        Tile& tile = zmap.tileForWriting(index);
        for (int j = rect.j0; j < rect.j1; ++j)
            for (int i = rect.i0; i < rect.i1; ++i)
                tile.at(i - rect.i0, j - rect.j0) =
                    static_cast<float>(std::clamp(heightAt({grid.x(i), grid.y(j)}), -stock.height, 0.0));
        tile.refreshMaximum();
    }
    return zmap.snapshot();
}

std::shared_ptr<const DesignPart> partOf(const Mesh& mesh, const Vec3& offset = Vec3(0)) {
    TriangleMesh placed{mesh.vertices, mesh.facets};
    for (Vec3& vertex : placed.vertices)
        vertex += offset;
    return std::make_shared<const DesignPart>(std::move(placed));
}

Deviation deviationOf(const ZMapSnapshot& stock, std::shared_ptr<const DesignPart> part,
                      const PartTolerance& tolerance = {}) {
    return *Deviation::of(stock, std::move(part), tolerance);
}

/// Calls `visit(place, value)` for the points that are judged.
template<class Visit>
void eachJudged(const Deviation& deviation, const Visit& visit) {
    const Grid& grid = deviation.grid();
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            if (const float value = deviation.at(i, j); !std::isnan(value))
                visit(Vec2(grid.x(i), grid.y(j)), double{value});
}

/// A ridge along Y, whose sides rise at 60°.
Mesh ridge() {
    Mesh mesh;
    const double high = 8 * std::tan(std::numbers::pi / 3);
    for (const double y : {-15.0, 15.0})
        for (const Vec2 place : {Vec2(-10, 0), Vec2(10, 0), Vec2(2, high), Vec2(-2, high)})
            mesh.vertices.emplace_back(place.x, y, place.y - 20);
    mesh.facets = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}, {0, 5, 1}, {0, 4, 5},
                   {1, 6, 2}, {1, 5, 6}, {2, 7, 3}, {2, 6, 7}, {3, 4, 0}, {3, 7, 4}};
    return mesh;
}

TEST(Deviation, OfASmallerSphereIsThatOfItsRadiusEverywhere) {
    const auto part = partOf(sphereMesh(15, 600), {0, 0, -16});
    for (const double off : {-0.1, 0.1, -0.5}) {
        const auto stock = mapOf(kStock, 0.25, [&](const Vec2& place) {
            const double squared = (15 + off) * (15 + off) - glm::dot(place, place);
            return squared > 0 ? std::sqrt(squared) - 16 : -30;
        });
        int judged = 0;
        eachJudged(deviationOf(stock, part), [&](const Vec2& place, double value) {
            if (glm::length(place) > 14.2) // the grid has steps there
                return;
            ++judged;
            EXPECT_NEAR(value, off, 0.01) << place.x << ' ' << place.y;
        });
        EXPECT_GT(judged, 9000);
    }
}

TEST(Deviation, OfAShiftedSlopeIsNormalToIt) {
    const auto part = partOf(ridge());
    const auto stock = mapOf(kStock, 0.5, [](const Vec2& place) {
        const double rise = (10 - std::abs(place.x + 0.05)) * std::tan(std::numbers::pi / 3);
        return std::clamp(rise, 0.0, 8 * std::tan(std::numbers::pi / 3)) - 20;
    });
    int judged = 0;
    eachJudged(deviationOf(stock, part), [&](const Vec2& place, double value) {
        if (std::abs(place.x) < 2.6 || std::abs(place.x) > 9.4 || std::abs(place.y) > 14)
            return;
        ++judged;
        const double expected = (place.x > 0 ? -0.05 : 0.05) * std::sin(std::numbers::pi / 3);
        EXPECT_NEAR(value, expected, 1e-4) << place.x << ' ' << place.y;
    });
    EXPECT_GT(judged, 1000);
}

TEST(Islands, OfPlantedGougesAreThree) {
    const auto part = partOf(boxMesh({-20, -20, -30}, {20, 20, -5}));
    const std::vector<std::pair<Vec2, double>> gouges{{{-10, -10}, 0.2}, {{0, 5}, 0.5}, {{12, -4}, 1.0}};
    const auto stock = mapOf(kStock, 0.25, [&](const Vec2& place) {
        for (const auto& [middle, depth] : gouges)
            if (glm::distance(place, middle) <= 2)
                return -5 - depth;
        return -5.0;
    });
    const PartTolerance tolerance{0.1, 0.1, 0};
    const auto islands = islandsOf(deviationOf(stock, part, tolerance), tolerance);
    ASSERT_EQ(islands.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& [middle, depth] = gouges[2 - k];
        EXPECT_EQ(islands[k].kind, IslandKind::gouge);
        EXPECT_NEAR(islands[k].depthMm, depth, 1e-5);
        EXPECT_NEAR(islands[k].areaMm2, std::numbers::pi * 4, 0.5);
        EXPECT_NEAR(islands[k].volumeMm3, std::numbers::pi * 4 * depth, 0.5 * depth);
        EXPECT_LE(glm::distance(Vec2(islands[k].place), middle), 2);
    }
}

TEST(Islands, OfAStockLikeThePartAreNone) {
    const auto part = partOf(ridge());
    const auto stock = mapOf(kStock, 0.5, [](const Vec2& place) {
        const double rise = (10 - std::abs(place.x)) * std::tan(std::numbers::pi / 3);
        return std::abs(place.y) > 15 ? -30 : std::clamp(rise, 0.0, 8 * std::tan(std::numbers::pi / 3)) - 20;
    });
    const PartTolerance tolerance{0.001, 0.001, 0};
    const Deviation deviation = deviationOf(stock, part, tolerance);
    eachJudged(deviation, [](const Vec2& place, double value) {
        EXPECT_NEAR(value, 0, 5e-6) << place.x << ' ' << place.y;
    });
    EXPECT_TRUE(islandsOf(deviation, tolerance).empty());
}

/// The points of the stock alone do not see these: they are near a face of the part, or on it.
TEST(Islands, OfAHoleAThinSkinAndAnUncutSlotAreFound) {
    Mesh plate = boxMesh({-20, -20, -30}, {20, 20, -20});
    const PartTolerance tolerance{0.1, 0.1, 0};
    const auto worst = [&](const Mesh& part, const std::function<double(const Vec2&)>& heightAt) {
        const auto isMaterial = [&](std::span<const Vec3> places) {
            std::vector<bool> is;
            for (const Vec3& place : places) {
                const double height = heightAt(Vec2(place));
                is.push_back(height > -30 && place.z <= height);
            }
            return is;
        };
        return islandsOf(
            *Deviation::of(mapOf(kStock, 0.25, heightAt), partOf(part), tolerance, {}, isMaterial),
            tolerance);
    };
    const auto inside = [](const Vec2& place) { return glm::length(place) <= 3; };
    const auto hole = worst(plate, [&](const Vec2& place) { return inside(place) ? -30.0 : -20.0; });
    ASSERT_EQ(hole.size(), 1U);
    EXPECT_EQ(hole[0].kind, IslandKind::gouge);
    EXPECT_NEAR(hole[0].depthMm, 3, 0.3); // its middle is a radius away from what is left
    EXPECT_NEAR(hole[0].volumeMm3, std::numbers::pi * 90, 10);

    const auto skin = worst(plate, [&](const Vec2& place) { return inside(place) ? -29.95 : -20.0; });
    ASSERT_EQ(skin.size(), 1U);
    EXPECT_EQ(skin[0].kind, IslandKind::gouge);
    EXPECT_NEAR(skin[0].depthMm, 3, 0.3);

    // Two boxes with a slot of 0.15 mm between them, over a third.
    Mesh slot = boxMesh({-20, -20, -25}, {0, 20, -20});
    const auto add = [&](const Mesh& box) {
        const auto first = static_cast<std::uint32_t>(slot.vertices.size());
        slot.vertices.insert(slot.vertices.end(), box.vertices.begin(), box.vertices.end());
        for (const auto& [a, b, c] : box.facets)
            slot.facets.push_back({first + a, first + b, first + c});
    };
    add(boxMesh({0.15, -20, -25}, {20, 20, -20}));
    add(boxMesh({-20, -20, -30}, {20, 20, -25}));
    const auto uncut = islandsOf(
        deviationOf(mapOf(kStock, 0.0625, [](const Vec2&) { return -20.0; }), partOf(slot), tolerance),
        tolerance);
    ASSERT_EQ(uncut.size(), 1U);
    EXPECT_EQ(uncut[0].kind, IslandKind::excess);
    EXPECT_NEAR(uncut[0].depthMm, 5, 1e-3);
}

TEST(Islands, OfAnUncutOutlineAreOnItsWalls) {
    const auto part = partOf(boxMesh({-10, -10, -20}, {10, 10, -5}));
    const PartTolerance tolerance{0.1, 0.1, 0};
    const auto stock = mapOf(kStock, 0.5, [](const Vec2&) { return -5.0; }); // only faced
    const auto islands = islandsOf(deviationOf(stock, part, tolerance), tolerance);
    ASSERT_EQ(islands.size(), 1U);
    EXPECT_EQ(islands[0].kind, IslandKind::excess);
    EXPECT_NEAR(islands[0].depthMm, 10, 0.3);     // to the sides of the stock, or to its top 15 mm above
    EXPECT_NEAR(islands[0].areaMm2, 80 * 15, 25); // without half a row along the top
}

/// The value of any point is that of brute force in both directions.
TEST(Deviation, OfRandomStepsIsThatOfBruteForce) {
    Random random(randomSeed());
    const StockBox stock{{0, 0, 0}, 6, 6, 8};
    for (int round = 0; round < 5; ++round) {
        const Mesh mesh = boxMesh({1.2, 1.3, -6.9}, {4.7, 4.6, -uniform(random, 1, 3)});
        const auto part = partOf(mesh);
        std::vector<double> steps(49);
        for (double& step : steps)
            step = -uniform(random, 0, 8);
        const auto zmap = mapOf(stock, 1, [&](const Vec2& place) {
            return steps[static_cast<std::size_t>(std::lround(place.y) * 7 + std::lround(place.x))];
        });
        const Deviation deviation = deviationOf(zmap, part, {0, 0, 0});
        const MapDistance distance(zmap);
        for (int k = 0; k < 200; ++k) {
            const Vec3 point(uniform(random, 0, 6), uniform(random, 0, 6), uniform(random, -8, 1));
            double least = std::numeric_limits<double>::infinity();
            const auto look = [&](const std::array<Vec3, 3>& corners) {
                least = std::min(least, glm::distance(point, nearestOnFacet(point, corners).place));
            };
            const auto at = [&](int i, int j) { return vertexAt(zmap, i, j); };
            for (int j = 0; j < 6; ++j)
                for (int i = 0; i < 6; ++i) {
                    const bool even = (i + j) % 2 == 0;
                    look({at(i, j), at(i + 1, j), even ? at(i + 1, j + 1) : at(i, j + 1)});
                    look({even ? at(i, j) : at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
                }
            const auto side = [&](Vec3 from, Vec3 to) {
                const Vec3 fromBelow(from.x, from.y, -8);
                const Vec3 toBelow(to.x, to.y, -8);
                look({from, to, toBelow});
                look({from, toBelow, fromBelow});
            };
            for (int n = 0; n < 6; ++n) {
                side(at(n, 0), at(n + 1, 0));
                side(at(n, 6), at(n + 1, 6));
                side(at(0, n), at(0, n + 1));
                side(at(6, n), at(6, n + 1));
            }
            const auto nearest = distance.nearest(point, 100);
            ASSERT_TRUE(nearest.has_value());
            EXPECT_NEAR(nearest->distance, least, 1e-12);
        }
    }
}

} // namespace
} // namespace proveout::test
