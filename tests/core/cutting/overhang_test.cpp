// SPDX-License-Identifier: GPL-3.0-or-later
// Material that remains above a head wider than its neck, compared with closed formulas, to the order of the
// spacing as in volume_test.cpp, and with brute force.
#include "core/cutting/cut/overhang.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "tests/core/cutting/oracle.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

const StockBox kStock{{0, 0, 0}, 60, 40, 20};

ZMap freshMap(double spacing = 0.1) {
    return {kStock, makeGrid(kStock, spacing).value()};
}

Overhang cutAndMeasure(ZMap& zmap, const Cutter& cutter, const Motion& motion) {
    const ZMapSnapshot before = zmap.snapshot();
    const CutRecord record = cut(zmap, cutter, motion);
    return overhangLeft(before, zmap.snapshot(), record.changed, cutter, motion, {}).value();
}

/// A motion from edge to edge through the middle of the stock.
Motion across(double z) {
    return straightMotion({-20, 20, z}, {80, 20, z});
}

TEST(Overhang, OfATSlotIsWhatStaysBesideTheNeck) {
    ZMap zmap = freshMap();
    (void)cut(zmap, cutterOf("flat:d=9"), across(-12));
    const Overhang left = cutAndMeasure(zmap, cutterOf("tslot:d=20,w=5,neck=9"), across(-12));
    const double exact = (20 - 9) * 60 * (12 - 5);
    EXPECT_NEAR(left.volumeMm3, exact, 2e-3 * exact);
    EXPECT_NEAR(left.height, 7, 1e-4);
    EXPECT_NEAR(left.place.z, -7, 1e-4);
    EXPECT_GE(std::abs(left.place.y - 20), 4.5);
    EXPECT_LE(std::abs(left.place.y - 20), 10.001);
    EXPECT_EQ(left.neckDepth, 0);
}

TEST(Overhang, OfALollipopFollowsItsRoundBack) {
    ZMap zmap = freshMap(0.05);
    (void)cut(zmap, cutterOf("flat:d=6"), across(-12));
    const Overhang left = cutAndMeasure(zmap, cutterOf("lollipop:d=10,neck=6"), across(-12));
    // Above the circle on both sides, from 3 to 5 mm: 2 · ∫ (7 - √(25 - y²)) dy.
    const auto under = [](double y) { return (y * std::sqrt(25 - y * y) + 25 * std::asin(y / 5)) / 2; };
    const double exact = 60 * 2 * (7 * 2 - (under(5) - under(3)));
    EXPECT_NEAR(left.volumeMm3, exact, 0.015 * exact);
    EXPECT_NEAR(left.height, 7, 0.2) << "at the widest place";
    EXPECT_EQ(left.neckDepth, 0);
}

TEST(Overhang, OfADovetailIsTheWedgeAboveItsFlanks) {
    ZMap zmap = freshMap(0.05);
    (void)cut(zmap, cutterOf("flat:d=10"), across(-5));
    const Overhang left = cutAndMeasure(zmap, cutterOf("dovetail:d=20,angle=45,h=5"), across(-5));
    const double exact = 60 * 5 * 5;
    EXPECT_NEAR(left.volumeMm3, exact, 0.015 * exact);
    EXPECT_NEAR(left.height, 5, 0.06);
}

TEST(Overhang, IsNoneWhereTheHeadClearsItsWayFromAbove) {
    for (const char* spec :
         {"lollipop:d=10,neck=6", "tslot:d=10,w=3,neck=5,r=0.5", "dovetail:d=10,angle=60,h=4"}) {
        SCOPED_TRACE(spec);
        ZMap zmap = freshMap();
        const Overhang plunge =
            cutAndMeasure(zmap, cutterOf(spec), straightMotion({30, 20, 2}, {30, 20, -9}));
        EXPECT_EQ(plunge.volumeMm3, 0);
        EXPECT_EQ(plunge.neckDepth, 0);
        const Overhang retract =
            cutAndMeasure(zmap, cutterOf(spec), straightMotion({30, 20, -9}, {30, 20, 2}));
        EXPECT_EQ(retract.volumeMm3, 0);
    }
}

TEST(Overhang, ReportsHowFarANeckGoesThroughStock) {
    ZMap zmap = freshMap();
    const Overhang left = cutAndMeasure(zmap, cutterOf("tslot:d=20,w=5,neck=9"), across(-12));
    EXPECT_NEAR(left.neckDepth, 7, 1e-4);
    EXPECT_NEAR(left.volumeMm3, 11 * 60 * 7, 11) << "what the neck took is no overhang";
}

TEST(Overhang, OfOtherCuttersIsNone) {
    ZMap zmap = freshMap(1);
    EXPECT_EQ(cutAndMeasure(zmap, cutterOf("ball:d=10"), across(-12)).volumeMm3, 0);
}

TEST(Overhang, WeighsPointsOnTheEdgeHalf) {
    ZMap zmap = freshMap();
    const Overhang left =
        cutAndMeasure(zmap, cutterOf("tslot:d=20,w=5,neck=9"), straightMotion({-20, 0, -12}, {80, 0, -12}));
    EXPECT_NEAR(left.volumeMm3, 5.5 * 60 * 7, 1);
}

/// The height of material over a point that no position of the head or the neck removes, from many positions
/// along the path.
double bruteForceHeight(const Cutter& cutter, const Motion& motion, const Vec2& at, double hi, double lo) {
    constexpr int kPlaces = 20000;
    const NeckedHead& head = *cutter.head();
    std::vector<Vec2> layers;
    double step = 0; // change in height of the tip between two positions
    for (int k = 0; k <= kPlaces; ++k) {
        const Vec3 tip = oraclePoint(motion, static_cast<double>(k) / kPlaces);
        step = std::max(step, std::abs(tip.z - oraclePoint(motion, (k + 1.0) / kPlaces).z));
        const double r = glm::distance(Vec2(tip), at);
        if (r > cutter.radius())
            continue;
        double top = r <= head.neckRadius ? 1e9 : 0;
        for (const ProfilePiece& piece : head.back)
            if (top == 0 && r <= piece.r1)
                top = heightOf(piece, r);
        layers.emplace_back(tip.z + cutter.height(r), tip.z + top);
    }
    std::ranges::sort(layers, {}, [](const Vec2& layer) { return layer.x; });
    double reached = lo;
    double sum = 0;
    for (const Vec2& layer : layers) {
        const double gap = std::min(layer.x, hi) - reached;
        sum += gap > 0.01 + 40 * step ? gap : 0;
        reached = std::max(reached, layer.y);
    }
    return sum + std::max(0.0, hi - reached);
}

TEST(Overhang, AgreesWithBruteForce) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Random random(seed);
    const StockBox stock{{-3, 5, 2}, 24, 18, 30};
    const char* shapes[] = {"lollipop", "tslot", "dovetail"};
    int found = 0;
    for (int k = 0; k < 36; ++k) {
        const Cutter cutter = randomCutter(random, shapes[k % 3]);
        const Motion motion = k % 2 == 0 ? randomStraight(random, stock, static_cast<StraightKind>(k / 2 % 5))
                                         : randomArc(random, stock, static_cast<Plane>(k / 2 % 3),
                                                     static_cast<ArcKind>(k / 6 % 3));
        SCOPED_TRACE(reported(cutter, motion));
        ZMap zmap(stock, makeGrid(stock, 1.5).value());
        const Overhang left = cutAndMeasure(zmap, cutter, motion);
        const ZMapSnapshot after = zmap.snapshot();
        const Grid& grid = zmap.grid();
        double volume = 0;
        for (int j = 0; j < grid.ny; ++j) {
            for (int i = 0; i < grid.nx; ++i) {
                const double lo = stock.topZ() + static_cast<double>(after.height(i, j));
                if (after.height(i, j) == 0)
                    continue;
                const double weight =
                    (i == 0 || i + 1 == grid.nx ? 0.5 : 1.0) * (j == 0 || j + 1 == grid.ny ? 0.5 : 1.0);
                volume += weight * grid.hx * grid.hy *
                          bruteForceHeight(cutter, motion, {grid.x(i), grid.y(j)}, stock.topZ(), lo);
            }
        }
        EXPECT_NEAR(left.volumeMm3, volume, 0.02 * volume + 1);
        found += volume > 10 ? 1 : 0;
    }
    EXPECT_GT(found, 8);
}

} // namespace
} // namespace proveout
