// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/solid.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

#include "tests/core/decimation/closed_mesh.h"
#include "tests/core/decimation/random_triangulation.h"
#include "tests/core/decimation/topology.h"
#include "tests/random_seed.h"

namespace proveout::test {
namespace {

/// A stock at an odd position, so that coordinates are not integers.
const StockBox kStock{{-70.3, 12.7, 1.9}, 7, 5, 30.1};
constexpr float kFloor = -30.1F;

/// A map of nx × ny points over a stock with spacing h.
struct Map {
    int nx = 3;
    int ny = 3;
    double hx = 1;
    double hy = 1;
    std::vector<float> heights;
    StockBox stock = kStock;

    [[nodiscard]] ZMapSnapshot zmap() const {
        StockBox box = stock;
        box.width = (nx - 1) * hx;
        box.depth = (ny - 1) * hy;
        ZMap map(box, Grid{nx, ny, hx, hy, box.corner.x, box.corner.y});
        const int tilesX = map.tilesX();
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                map.tileForWriting(static_cast<std::size_t>(j / Tile::kSize * tilesX + i / Tile::kSize))
                    .at(i % Tile::kSize, j % Tile::kSize) = heights[static_cast<std::size_t>(j * nx + i)];
        return map.snapshot();
    }
};

/// The volume between surface and floor, prism by prism.
double prismVolume(const Map& map, const std::vector<LatticeTriangle>& triangles) {
    double volume = 0;
    for (const LatticeTriangle& t : triangles) {
        const auto x = [&](std::uint32_t v) {
            return static_cast<double>(static_cast<int>(v) % map.nx) * map.hx;
        };
        const auto y = [&](std::uint32_t v) {
            return static_cast<double>(static_cast<int>(v) / map.nx) * map.hy;
        };
        const double area =
            ((x(t[1]) - x(t[0])) * (y(t[2]) - y(t[0])) - (x(t[2]) - x(t[0])) * (y(t[1]) - y(t[0]))) / 2;
        double height = 0;
        for (const auto v : t)
            height += (static_cast<double>(map.heights[v]) + map.stock.height) / 3;
        volume += area * height;
    }
    return volume;
}

bool isEmpty(const TriangleMesh& mesh) {
    return mesh.vertices.empty() && mesh.triangles.empty();
}

/// A solid must be valid, and its volume must match the surface except for the gaps.
void expectSound(const Map& map, const std::vector<LatticeTriangle>& triangles) {
    const TriangleMesh solid = closeSolid(map.zmap(), triangles);
    const double wanted = prismVolume(map, triangles);
    const double area = (map.nx - 1) * map.hx * (map.ny - 1) * map.hy;
    // In height the difference is at most the gap over the whole area; in plan at most two gaps at each
    // vertex, where the material is at most as high as the stock.
    const double points = static_cast<double>(map.heights.size());
    const double slack = 2 * kPinchGap * (area + points * map.stock.height * std::max(map.hx, map.hy));
    if (isEmpty(solid)) {
        ASSERT_LE(wanted, slack);
        return;
    }
    ASSERT_EQ(whatIsWrong(solid), "");
    ASSERT_NEAR(signedVolume(solid), wanted, slack);
    ASSERT_GT(smallestPartVolume(solid), 0);
}

TEST(Solid, UncutStockIsItsBox) {
    Map map;
    map.heights.assign(9, 0);
    const TriangleMesh solid = closeSolid(map.zmap(), std::vector<LatticeTriangle>{{0, 2, 8}, {0, 8, 6}});
    EXPECT_EQ(whatIsWrong(solid), "");
    EXPECT_EQ(solid.vertices.size(), 8U);
    EXPECT_EQ(solid.triangles.size(), 12U);
    EXPECT_NEAR(signedVolume(solid), 2 * 2 * 30.1, 1e-9);
    Box3 box;
    for (const Vec3& vertex : solid.vertices)
        box.add(vertex);
    EXPECT_LT(glm::length(box.lo - Vec3(-70.3, 12.7, 1.9 - 30.1)), 1e-12);
    EXPECT_LT(glm::length(box.hi - Vec3(-68.3, 14.7, 1.9)), 1e-12);
}

TEST(Solid, WallsAndFloorAreFewTrianglesWhereNothingTouchesTheFloor) {
    Map map{40, 30, 0.1, 0.2, {}, kStock};
    map.heights.assign(40 * 30, -1);
    const auto triangles = fullTriangulation(map.nx, map.ny);
    const TriangleMesh solid = closeSolid(map.zmap(), triangles);
    // Each side is a chain of n points and a base, and so has n triangles.
    EXPECT_EQ(solid.triangles.size(), triangles.size() + 2 + 2 * 40 + 2 * 30);
    EXPECT_EQ(solid.vertices.size(), 40 * 30 + 4U);
    expectSound(map, triangles);
}

/// The flanks of a V-groove that leaves the stock are straight lines except for the last bits, which differ
/// between double and float32. There must be no wall triangle on such a line.
TEST(Solid, WallsUnderStraightFlanksFaceOutwardsInDoubleAndInFloat) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 200; ++round) {
        SCOPED_TRACE(round);
        Map map{3 + static_cast<int>(random() % 60),
                3,
                0.1 * static_cast<double>(1 + random() % 9),
                1.0 / 3,
                {},
                kStock};
        map.stock.corner.x = static_cast<double>(random() % 1000) * 0.37 - 185;
        const double bottom = map.hx * static_cast<double>(random() % static_cast<unsigned>(map.nx));
        const double slope = 25 / (map.hx * map.nx);
        for (int v = 0; v < map.nx * map.ny; ++v)
            map.heights.push_back(kFloor + 0.5F +
                                  static_cast<float>(slope * std::abs(map.hx * (v % map.nx) - bottom)));
        expectSound(map, fullTriangulation(map.nx, map.ny));
        if (HasFailure())
            return;
    }
}

TEST(Solid, NothingLeftIsAnEmptyMesh) {
    Map map{5, 4, 1, 1, std::vector<float>(20, kFloor), kStock};
    EXPECT_TRUE(isEmpty(closeSolid(map.zmap(), fullTriangulation(5, 4))));
    // Stock so thin that float32 cannot separate it from the floor counts as empty too.
    map.heights.assign(20, std::nextafter(kFloor, 0.0F));
    EXPECT_TRUE(isEmpty(closeSolid(map.zmap(), fullTriangulation(5, 4))));
}

TEST(Solid, AStoppedContextGivesNothing) {
    Map map{3, 3, 1, 1, std::vector<float>(9, 0), kStock};
    std::stop_source stop;
    stop.request_stop();
    WorkContext context;
    context.stop = stop.get_token();
    EXPECT_TRUE(isEmpty(closeSolid(map.zmap(), fullTriangulation(3, 3), context)));
}

TEST(Solid, ProgressRisesToOne) {
    for (const float lowest : {-1.0F, kFloor}) {
        Map map{9, 9, 1, 1, std::vector<float>(81, 0), kStock};
        map.heights[40] = lowest;
        std::vector<double> reported;
        WorkContext context;
        context.progress = [&reported](double done) { reported.push_back(done); };
        EXPECT_FALSE(isEmpty(closeSolid(map.zmap(), fullTriangulation(9, 9), context)));
        EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
        EXPECT_EQ(reported.back(), 1);
    }
}

/// Rows of '.' (floor) and '#' (stock), the first with the highest y.
Map drawn(const std::vector<std::string>& rows) {
    Map map;
    map.nx = static_cast<int>(rows.front().size());
    map.ny = static_cast<int>(rows.size());
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        for (const char c : *row)
            map.heights.push_back(c == '#' ? -1.0F : kFloor);
    return map;
}

std::size_t partsOf(const Map& map) {
    const auto triangles = fullTriangulation(map.nx, map.ny);
    expectSound(map, triangles);
    return partCount(closeSolid(map.zmap(), triangles));
}

TEST(Solid, ASlotThroughTheStockMakesTwoParts) {
    EXPECT_EQ(partsOf(drawn({"###..###", "###..###", "###..###"})), 2U);
    EXPECT_EQ(partsOf(drawn({"########", "###..###", "###..###"})), 1U);
}

TEST(Solid, AGrooveThatTouchesTheFloorAlongALineKeepsASkin) {
    const Map map = drawn({"###.###", "###.###", "###.###"});
    EXPECT_EQ(partsOf(map), 1U);
    double lowest = 0;
    for (const Vec3& vertex : closeSolid(map.zmap(), fullTriangulation(7, 3)).vertices)
        lowest = std::min(lowest, vertex.z);
    EXPECT_NEAR(lowest, kStock.floorZ() - kPinchGap, 1e-9);
}

TEST(Solid, HolesThatMeetInAVertexArePinchedOff) {
    // Here the diagonals run so that the two holes are separated only by a vertex and not by a triangle.
    const Map map = drawn({"######", "#..###", "#..###", "###..#", "###..#", "######"});
    EXPECT_EQ(partsOf(map), 1U);
    const Map corner = drawn({"...##", "...##", "...##", "##...", "##...", "##..."});
    EXPECT_EQ(partsOf(corner), 2U);
}

TEST(Solid, IslandsAreSeparate) {
    EXPECT_EQ(partsOf(drawn({"#.....#", ".......", ".......", "...#...", ".......", ".......", "#.....#"})),
              5U);
}

TEST(Solid, APitThatTouchesTheFloorInOnePointKeepsASkin) {
    EXPECT_EQ(partsOf(drawn({"#####", "#####", "##.##", "#####", "#####"})), 1U);
    EXPECT_EQ(partsOf(drawn({"##.##", "#####", "#####"})), 1U);
    EXPECT_EQ(partsOf(drawn({".####", "#####", "#####"})), 1U);
}

/// All patterns of floor and stock on small maps.
void checkEveryPattern(int nx, int ny) {
    Map map{nx, ny, 0.7, 1.3, {}, kStock};
    const auto triangles = fullTriangulation(nx, ny);
    const std::size_t points = static_cast<std::size_t>(nx * ny);
    for (std::size_t pattern = 0; pattern < std::size_t{1} << points; ++pattern) {
        map.heights.clear();
        for (std::size_t v = 0; v < points; ++v)
            map.heights.push_back((pattern >> v & 1) != 0 ? kFloor : -static_cast<float>(v) - 0.5F);
        SCOPED_TRACE(pattern);
        expectSound(map, triangles);
        if (testing::Test::HasFatalFailure())
            return;
    }
}

TEST(Solid, EveryPatternOfFloorAndStockIsSound) {
    checkEveryPattern(2, 2);
    checkEveryPattern(3, 2);
    checkEveryPattern(3, 3);
    checkEveryPattern(4, 3);
}

float randomHeight(std::mt19937& random, unsigned floorPercent) {
    const auto choice = random() % 100;
    if (choice < floorPercent)
        return kFloor;
    if (choice < floorPercent + 5)
        return kFloor + 1e-5F * static_cast<float>(random() % 30); // close to the gap
    return kFloor * static_cast<float>(random()) / 4294967296.0F;
}

TEST(Solid, RandomMapsAndTriangulationsAreSound) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 3000; ++round) {
        SCOPED_TRACE(round);
        Map map;
        map.nx = 2 + static_cast<int>(random() % 12);
        map.ny = 2 + static_cast<int>(random() % 12);
        map.hx = 0.05 + static_cast<double>(random() % 100) / 50;
        map.hy = 0.05 + static_cast<double>(random() % 100) / 50;
        const unsigned percents[] = {0, 5, 30, 50, 70, 95};
        const unsigned percent = percents[random() % 6];
        map.heights.resize(static_cast<std::size_t>(map.nx * map.ny));
        std::generate(map.heights.begin(), map.heights.end(), [&] { return randomHeight(random, percent); });
        const auto triangles = randomTriangulation(map.nx, map.ny, random() % 400, random);
        expectCoversMap(map.nx, map.ny, triangles);
        expectSound(map, triangles);
        if (HasFailure())
            return;
    }
}

/// Coordinates so large that the step of float32 is 1/8 mm: the gap grows, but the topology stays valid.
TEST(Solid, FarFromTheOriginTheGapGrows) {
    Map map = drawn({"######", "#..###", "#..###", "###..#", "###..#", "######"});
    map.hx = 10;
    map.hy = 10;
    map.stock = StockBox{{1e6, -1e6, 0}, 1, 1, 30.1};
    EXPECT_EQ(whatIsWrong(closeSolid(map.zmap(), fullTriangulation(6, 6))), "");
}

TEST(Solid, LowWallsOverALongFloorAreSound) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 50; ++round) {
        Map map{300, 3, 1, 1, {}, kStock};
        for (int v = 0; v < 900; ++v)
            map.heights.push_back(kFloor + 2e-4F + 1e-5F * static_cast<float>(random() % 100));
        EXPECT_EQ(whatIsWrong(closeSolid(map.zmap(), fullTriangulation(300, 3))), "");
    }
}

} // namespace
} // namespace proveout::test
