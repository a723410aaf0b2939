// SPDX-License-Identifier: GPL-3.0-or-later
// Compares outlines with closed forms.
#include "core/zmap/extruded_stock.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <string>

#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr double kPi = std::numbers::pi;

struct Made {
    StockBox box;
    UncutStock uncut;

    [[nodiscard]] double volume() const { return uncut.zmap.snapshot().volume(); }
};

Made made(const std::vector<OutlineLoop>& loops, double height, double spacing) {
    const auto body = extrudedStock(loops, height).value();
    const StockBox box = body->box();
    return {box, body->uncut(box, makeGrid(box, spacing).value())};
}

OutlineLoop loopOf(std::initializer_list<Vec2> points) {
    OutlineLoop loop;
    for (const Vec2& point : points)
        loop.push_back({point});
    return loop;
}

TEST(ExtrudedStock, CylinderHasItsVolume) {
    for (const double diameter : {10.0, 33.3, 50.0}) {
        const Made cylinder = made({circleOutline(diameter)}, 20, 0.1);
        EXPECT_EQ(cylinder.box, (StockBox{{0, 0, 0}, diameter, diameter, 20}));
        EXPECT_NEAR(cylinder.volume() / (kPi / 4 * diameter * diameter * 20), 1, 0.002) << diameter;
        EXPECT_TRUE(cylinder.uncut.findings.empty());
    }
}

TEST(ExtrudedStock, CylinderIsRoundAtEveryPoint) {
    const Made cylinder = made({circleOutline(30)}, 5, 0.5);
    const Grid& grid = cylinder.uncut.zmap.grid();
    const ZMapSnapshot map = cylinder.uncut.zmap.snapshot();
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const double distance = std::hypot(grid.x(i) - 15, grid.y(j) - 15);
            EXPECT_EQ(map.height(i, j), distance <= 15 + 1e-9 ? 0.0F : -5.0F) << i << ' ' << j;
        }
}

TEST(ExtrudedStock, RectangleIsABox) {
    const Made plate = made({loopOf({{3, 4}, {43, 4}, {43, 34}, {3, 34}})}, 10, 0.7);
    EXPECT_EQ(plate.box, (StockBox{{3, 4, 0}, 40, 30, 10}));
    EXPECT_DOUBLE_EQ(plate.volume(), 40 * 30 * 10);
}

TEST(ExtrudedStock, PolygonHasItsAreaAndHolesAreNoMaterial) {
    const OutlineLoop triangle = loopOf({{0, 0}, {60, 10}, {20, 50}});
    EXPECT_NEAR(made({triangle}, 1, 0.05).volume(), 1400, 1400 * 0.002);
    const OutlineLoop hole = loopOf({{20, 15}, {30, 15}, {30, 25}, {20, 25}});
    EXPECT_NEAR(made({triangle, hole}, 1, 0.05).volume(), 1300, 1300 * 0.003);
    // Neither the sequence nor the orientation of the loops matters.
    const OutlineLoop back(hole.rbegin(), hole.rend());
    EXPECT_EQ(made({back, triangle}, 1, 0.05).volume(), made({triangle, hole}, 1, 0.05).volume());
}

TEST(ExtrudedStock, ArcsOfEitherSenseHaveTheirArea) {
    // A square with sides of 20 whose upper side is a half circle, outwards or inwards.
    for (const double bulge : {1.0, -1.0}) {
        OutlineLoop loop = loopOf({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
        loop[2].bulge = bulge;
        const double area = 400 + bulge * kPi * 100 / 2;
        EXPECT_NEAR(made({loop}, 1, 0.05).volume(), area, area * 0.003) << bulge;
    }
    // A quarter circle in each corner: a rounded square.
    const double quarter = std::tan(kPi / 8);
    OutlineLoop rounded;
    const Vec2 corners[] = {{5, 0}, {25, 0}, {30, 5}, {30, 25}, {25, 30}, {5, 30}, {0, 25}, {0, 5}};
    for (std::size_t k = 0; k < 8; ++k)
        rounded.push_back({corners[k], k % 2 == 1 ? quarter : 0});
    const double area = 900 - (4 - kPi) * 25;
    EXPECT_NEAR(made({rounded}, 1, 0.05).volume(), area, area * 0.002);
    EXPECT_NEAR(made({rounded}, 1, 0.05).box.width, 30, 1e-9);
}

TEST(ExtrudedStock, RandomStarsHaveTheirAreaAndMoveWithTheirBox) {
    for (std::uint_fast32_t seed = 1; seed <= 40; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> radius(10, 40);
        OutlineLoop star;
        constexpr int kPoints = 11;
        for (int k = 0; k < kPoints; ++k) {
            const double angle = 2 * kPi * k / kPoints;
            const double r = radius(random);
            star.push_back({{r * std::cos(angle), r * std::sin(angle)}});
        }
        double area = 0;
        for (std::size_t k = 0; k < star.size(); ++k) {
            const Vec2 a = star[k].at;
            const Vec2 b = star[(k + 1) % star.size()].at;
            area += (a.x * b.y - a.y * b.x) / 2;
        }
        const auto body = extrudedStock({star}, 7).value();
        StockBox box = body->box();
        const double volume = body->uncut(box, makeGrid(box, 0.1).value()).zmap.snapshot().volume();
        EXPECT_NEAR(volume, area * 7, area * 7 * 0.003) << "seed " << seed;
        const ZMapSnapshot before = body->uncut(box, makeGrid(box, 1).value()).zmap.snapshot();
        box.corner += Vec3(128, -64, 3);
        const ZMapSnapshot moved = body->uncut(box, makeGrid(box, 1).value()).zmap.snapshot();
        EXPECT_NEAR(moved.volume(), before.volume(), before.volume() * 0.01) << "seed " << seed;
    }
}

TEST(ExtrudedStock, TopIsAsHighAsTheMapAndItsBoundHolds) {
    OutlineLoop hole = circleOutline(12);
    for (OutlinePoint& point : hole)
        point.at += Vec2(14, 10);
    const auto body = extrudedStock({loopOf({{0, 0}, {50, 5}, {40, 45}, {10, 30}}), hole}, 9).value();
    const StockBox box = body->box();
    const auto top = body->top(box);
    const UncutStock uncut = body->uncut(box, makeGrid(box, 1).value());
    const ZMapSnapshot map = uncut.zmap.snapshot();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(0, 50);
    std::uniform_real_distribution<double> size(0.01, 6);
    int absent = 0;
    for (int k = 0; k < 20'000; ++k) {
        const Vec2 lo(side(random), side(random));
        const Vec2 hi = lo + Vec2(size(random), size(random));
        const double bound = top->highest(lo, hi);
        absent += bound == StockTop::kAbsent ? 1 : 0;
        for (const double u : {0.0, 0.5, 1.0})
            for (const double v : {0.0, 0.5, 1.0})
                EXPECT_LE(top->height(lo + (hi - lo) * Vec2(u, v)), bound);
    }
    EXPECT_GT(absent, 3000) << "the bound tells nothing";
    for (int j = 0; j < map.grid().ny; ++j)
        for (int i = 0; i < map.grid().nx; ++i)
            EXPECT_EQ(map.height(i, j) == 0, top->height({map.grid().x(i), map.grid().y(j)}) == 0);
}

TEST(ExtrudedStock, RefusesWhatIsNoOutline) {
    EXPECT_EQ(extrudedStock({}, 5).error().front().id, std::string("outline-without-area"));
    EXPECT_FALSE(extrudedStock({loopOf({{0, 0}, {5, 0}})}, 5));
    EXPECT_FALSE(extrudedStock({loopOf({{0, 0}, {5e9, 0}, {1, 1}})}, 5));
    EXPECT_FALSE(extrudedStock({{{{0, 0}, 1e9}, {{5, 5}}}}, 5));
    EXPECT_FALSE(extrudedStock({{{{0, std::nan("")}}, {{5, 5}}, {{6, 1}}}}, 5));
}

bool crosses(const std::vector<OutlineLoop>& loops) {
    const auto body = extrudedStock(loops, 5);
    if (!body) {
        EXPECT_STREQ(body.error().front().id, "outline-crosses-itself");
    }
    return !body;
}

TEST(ExtrudedStock, OutlinesThatCrossThemselvesAreRefusedWithThePlace) {
    const auto bow = extrudedStock({loopOf({{0, 0}, {10, 10}, {10, 0}, {0, 10}})}, 5);
    ASSERT_FALSE(bow.has_value());
    EXPECT_EQ(bow.error().front().arguments, (std::vector<Argument>{"5.000", "5.000"}));
    EXPECT_TRUE(crosses({loopOf({{0, 0}, {10, 0}, {10, 8}, {4, 8}, {4, -3}, {0, -3}})}))
        << "through a level side";
    EXPECT_TRUE(crosses({loopOf({{0, 0}, {20, 0}, {20, 10}, {0, 10}}), loopOf({{15, 3}, {25, 5}, {15, 7}})}));
    EXPECT_TRUE(crosses({circleOutline(20), {{{9, 10}, 1}, {{29, 10}, 1}}}));
    // Loops that only touch are accepted.
    EXPECT_FALSE(
        crosses({loopOf({{0, 0}, {20, 0}, {20, 10}, {0, 10}}), loopOf({{15, 3}, {20, 5}, {15, 7}})}));
    EXPECT_FALSE(crosses({circleOutline(20), {{{5, 10}, 1}, {{20, 10}, 1}}}));
    EXPECT_FALSE(crosses({loopOf({{0, 0}, {10, 0}, {10, 0}, {10, 5}, {20, 5}, {10, 5}, {10, 10}, {0, 10}})}));
}

/// Checks every side against every other one.
bool crossesByBruteForce(const OutlineLoop& loop) {
    const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const std::size_t count = loop.size();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 2; j < count; ++j) {
            const Vec2 a = loop[i].at;
            const Vec2 b = loop[i + 1].at;
            const Vec2 c = loop[j].at;
            const Vec2 d = loop[(j + 1) % count].at;
            if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0)
                return true;
        }
    return false;
}

TEST(ExtrudedStock, CrossingsAreFoundAsByBruteForce) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    int crossing = 0;
    for (int round = 0; round < roundsOf(3000); ++round) {
        // Points around the centre, so that many loops cross themselves and many do not; integer positions,
        // so that sides are horizontal, vertical, and touch.
        OutlineLoop loop;
        const std::size_t count = 4 + random() % 9;
        for (std::size_t k = 0; k < count; ++k) {
            const double angle = 2 * kPi *
                                 (static_cast<double>(k) + 3 * static_cast<double>(random() % 100) / 100) /
                                 static_cast<double>(count);
            const double radius = 20 + static_cast<double>(random() % 60);
            loop.push_back({{std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))}});
        }
        const bool expected = crossesByBruteForce(loop);
        const auto body = extrudedStock({loop}, 5);
        const bool found = !body && std::string(body.error().front().id) == "outline-crosses-itself";
        crossing += expected ? 1 : 0;
        std::string reported;
        for (const OutlinePoint& point : loop)
            reported += std::to_string(point.at.x) + "," + std::to_string(point.at.y) + " ";
        ASSERT_EQ(found, expected) << reported;
    }
    EXPECT_GT(crossing, roundsOf(3000) / 10);
}

} // namespace
} // namespace proveout
