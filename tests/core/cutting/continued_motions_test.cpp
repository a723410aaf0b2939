// SPDX-License-Identifier: GPL-3.0-or-later
// A motion that continues the one before leaves out what is under its start: the map must be the same.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/cutter/shapes.h"
#include "core/cutting/cut/cutting.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

const StockBox kSmallStock{{-3, 5, 2}, 30, 25, 12};
constexpr double kFine = 0.15;
constexpr double kExact = 1e-3; // mm

Motion nextMotion(Random& random, const Vec3& from) {
    if (random() % 5 == 0) {
        Motion arc = randomArc(random, kSmallStock, static_cast<Plane>(random() % 3),
                               static_cast<ArcKind>(random() % 4));
        const Vec3 shift = from - arc.start;
        arc.start = from;
        arc.end += shift;
        arc.centre += shift;
        return arc;
    }
    return straightMotion(from,
                          randomStraight(random, kSmallStock, static_cast<StraightKind>(random() % 5)).end);
}

/// Motions of one cutter, each from the end of the one before.
std::vector<CutterMotion> randomChain(Random& random, const Cutter& cutter, int count) {
    std::vector<CutterMotion> chain;
    Vec3 place = randomStraight(random, kSmallStock, StraightKind::sloped).start;
    for (int k = 0; k < count; ++k) {
        // Short steps in turn with long ones, as most programs have them.
        Motion motion = nextMotion(random, place);
        if (motion.kind != MotionKind::arc && random() % 2 == 0)
            motion.end = motion.start + (motion.end - motion.start) * 0.05;
        place = motion.end;
        chain.push_back({&cutter, motion});
        chain.back().continues = k > 0 && continues(*(chain.end() - 2), chain.back());
    }
    return chain;
}

std::vector<float> heightsOf(const ZMap& zmap) {
    const Grid& grid = zmap.grid();
    std::vector<float> heights(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny));
    zmap.snapshot().read({0, 0, grid.nx, grid.ny}, heights);
    return heights;
}

/// Beside a wall that is nearly upright less than a micrometre makes a large difference in height.
bool isBesideWall(const std::vector<float>& heights, const Grid& grid, int i, int j) {
    constexpr double kSteepest = 5;
    const auto at = [&](int column, int row) {
        return double{heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.nx) +
                              static_cast<std::size_t>(column)]};
    };
    double largest = 0;
    for (int row = std::max(j - 1, 0); row <= std::min(j + 1, grid.ny - 1); ++row) {
        for (int column = std::max(i - 1, 0); column <= std::min(i + 1, grid.nx - 1); ++column)
            largest = std::max(largest, std::abs(at(column, row) - at(i, j)));
    }
    return largest > kSteepest * kFine;
}

double largestDifference(const ZMap& a, const ZMap& b) {
    const Grid& grid = a.grid();
    const std::vector<float> first = heightsOf(a);
    const std::vector<float> second = heightsOf(b);
    double largest = 0;
    for (std::size_t k = 0; k < first.size(); ++k) {
        const double difference = std::abs(double{first[k]} - double{second[k]});
        const int j = static_cast<int>(k) / grid.nx;
        const int i = static_cast<int>(k) % grid.nx;
        if (difference > largest && !isBesideWall(first, grid, i, j))
            largest = difference;
    }
    return largest;
}

class ContinuedMotions : public testing::TestWithParam<std::string> {};

TEST_P(ContinuedMotions, LeaveTheSameMap) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Grid grid = makeGrid(kSmallStock, kFine).value();
    for (int round = 0; round < roundsOf(8); ++round) {
        const Cutter cutter = randomCutter(random, GetParam());
        const std::vector<CutterMotion> chain = randomChain(random, cutter, 30);
        ZMap whole(kSmallStock, grid);
        ZMap continued(kSmallStock, grid);
        double removedWhole = 0;
        double removed = 0;
        for (const CutterMotion& one : chain) {
            removedWhole += cut(whole, cutter, one.motion).removedMm3;
            removed += cut(continued, one, {})->removedMm3;
        }
        EXPECT_LE(largestDifference(whole, continued), kExact) << round;
        EXPECT_NEAR(removed, removedWhole, kExact * kSmallStock.width * kSmallStock.depth);
    }
}

std::vector<std::string> shapeKeys() {
    std::vector<std::string> keys;
    for (const CutterShape& shape : cutterShapes())
        keys.emplace_back(shape.key);
    return keys;
}

INSTANTIATE_TEST_SUITE_P(EveryShape, ContinuedMotions, testing::ValuesIn(shapeKeys()),
                         [](const testing::TestParamInfo<std::string>& one) { return one.param; });

TEST(Continuing, NeedsTheSameCutterAndThePlaceWhereAKnownMotionEnded) {
    const Cutter ball = cutterOf("ball:d=6");
    const Cutter other = cutterOf("ball:d=6");
    const CutterMotion before{&ball, straightMotion({0, 0, 0}, {5, 1, 2})};
    const CutterMotion motion{&ball, straightMotion({5, 1, 2}, {9, 9, 9})};
    EXPECT_TRUE(continues(before, motion));
    EXPECT_FALSE(continues(before, {&other, motion.motion}));
    EXPECT_FALSE(continues({nullptr, before.motion}, motion));
    EXPECT_FALSE(continues(before, {&ball, straightMotion({5, 1, 2.0000001}, {9, 9, 9})}));
    CutterMotion unknown = before;
    unknown.motion.startKnown = kAxisX;
    EXPECT_FALSE(continues(unknown, motion));
}

/// Cut alone, such a motion shows what it leaves to the one before.
TEST(Continuing, LeavesOutWhatIsUnderTheStart) {
    const Cutter flat = cutterOf("flat:d=6");
    const StockBox stock{{0, 0, 0}, 30, 10, 5};
    ZMap zmap(stock, makeGrid(stock, 0.5).value());
    CutterMotion motion{&flat, straightMotion({10.25, 5, -2}, {20, 5, -2})};
    motion.continues = true;
    const auto record = cut(zmap, motion, {});
    ASSERT_TRUE(record);
    EXPECT_EQ(record->changed.i0, 21);
    EXPECT_EQ(zmap.snapshot().height(20, 10), 0.0F);
    EXPECT_EQ(zmap.snapshot().height(21, 10), -2.0F);
}

} // namespace
} // namespace proveout
