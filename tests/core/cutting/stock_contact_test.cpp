// SPDX-License-Identifier: GPL-3.0-or-later
// Where a probe touches the stock, compared with closed formulas and with a brute-force search over dense
// columns and times that uses only the envelope.
#include "core/cutting/cut/stock_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "core/cutting/cut/cutting.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

const StockBox kStock{{0, 0, 0}, 40, 30, 10};
constexpr double kTolerance = StockContact::kTolerance;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// A stock after its cuts, which are all considered in a query.
struct CutStock {
    std::vector<PastCut> cuts;
    StockContact contact{kStock, [this](const Vec2&, const Vec2&) { return cuts; }, {}};

    explicit CutStock(std::vector<PastCut> past = {}) : cuts(std::move(past)) {}
    CutStock(const CutStock&) = delete;
    CutStock& operator=(const CutStock&) = delete;

    /// The way in mm until the touch.
    [[nodiscard]] double way(const Cutter& cutter, const Vec3& start, const Vec3& end) const {
        const auto time = contact.firstTouch(cutter, start, end);
        return time ? *time * glm::distance(start, end) : kNever;
    }
    [[nodiscard]] double wayToFree(const Cutter& cutter, const Vec3& start, const Vec3& end) const {
        const auto time = contact.firstFree(cutter, start, end);
        return time ? *time * glm::distance(start, end) : kNever;
    }
};

TEST(StockContact, OfAFlatTop) {
    const CutStock stock;
    for (const char* spec : {"ball:d=6", "flat:d=4", "bull:d=6,r=1", "cone:d=8,angle=90"})
        EXPECT_NEAR(stock.way(cutterOf(spec), {20.3, 15.2, 7}, {20.3, 15.2, -5}), 7, kTolerance) << spec;
}

TEST(StockContact, IsMissedBesideTheStockAndAboveIt) {
    const CutStock stock;
    const Cutter ball = cutterOf("ball:d=6");
    EXPECT_EQ(stock.way(ball, {20, 15, 7}, {20, 15, 0.01}), kNever);
    EXPECT_EQ(stock.way(ball, {43.01, 15, 7}, {43.01, 15, -9}), kNever);
    EXPECT_EQ(stock.way(ball, {-10, 15, 0.01}, {60, 15, 0.01}), kNever);
}

TEST(StockContact, OfTheSideOfTheStock) {
    const CutStock stock;
    EXPECT_NEAR(stock.way(cutterOf("flat:d=4"), {-10, 15, -3}, {5, 15, -3}), 8, kTolerance);
    EXPECT_NEAR(stock.way(cutterOf("ball:d=3"), {20, 44, -3}, {20, 14, -3}), 12.5, kTolerance);
}

TEST(StockContact, OfAStepFromTheSide) {
    const Cutter mill = cutterOf("flat:d=8");
    const CutStock stock({{straightMotion({20, -10, -5}, {20, 40, -5}), &mill}});
    EXPECT_NEAR(stock.way(cutterOf("flat:d=4"), {20, 15.1, -3}, {30, 15.1, -3}), 2, kTolerance);
    EXPECT_NEAR(stock.way(cutterOf("ball:d=3"), {20, 15.1, -3}, {30, 15.1, -3}), 2.5, kTolerance);
    // Higher up, only the ball's flank is below the edge.
    const double z = -0.4;
    const double r = std::sqrt(1.5 * 1.5 - (1.5 + z) * (1.5 + z));
    EXPECT_NEAR(stock.way(cutterOf("ball:d=3"), {20, 15.1, z}, {30, 15.1, z}), 4 - r, kTolerance);
}

TEST(StockContact, OfABallOnAnEdge) {
    const Cutter mill = cutterOf("flat:d=8");
    const CutStock stock({{straightMotion({20, -10, -5}, {20, 40, -5}), &mill}});
    const Cutter ball = cutterOf("ball:d=6");
    for (const double beside : {0.4, 1.2, 2.3, 2.9}) {
        const double fall = 3 - std::sqrt(9 - beside * beside);
        EXPECT_NEAR(stock.way(ball, {40 + beside, 11.3, 2}, {40 + beside, 11.3, -8}), 2 + fall, kTolerance);
        EXPECT_NEAR(stock.way(ball, {24 - beside, 11.3, 2}, {24 - beside, 11.3, -8}), 2 + fall, kTolerance);
    }
}

TEST(StockContact, OfTheSlopingFloorThatABallLeft) {
    const Cutter mill = cutterOf("ball:d=10");
    const Vec3 from(-20, 15, -3);
    const Vec3 to(60, 15, -8);
    const CutStock stock({{straightMotion(from, to), &mill}});
    const double slope = (to.z - from.z) / (to.x - from.x);
    for (const double x : {12.34, 20.0, 27.77}) {
        const double axis = from.z + slope * (x - from.x) + 5;
        const double tip = axis - 3 * std::sqrt(1 + slope * slope) - 2;
        EXPECT_NEAR(stock.way(cutterOf("ball:d=4"), {x, 15, 5}, {x, 15, -10}), 5 - tip, kTolerance) << x;
    }
}

TEST(StockContact, OfARoundPocketIsTheSameInEveryDirection) {
    const Cutter mill = cutterOf("flat:d=6");
    const CutStock stock({{straightMotion({10, 15, -4}, {30, 15, -4}), &mill},
                          {straightMotion({20, 10, -4}, {20, 20, -4}), &mill},
                          {arcMotion(Plane::xy, {20, 15, -4}, 4, 0, 2 * std::numbers::pi, 0, 4), &mill},
                          {arcMotion(Plane::xy, {20, 15, -4}, 8, 0, 2 * std::numbers::pi, 0, 8), &mill}});
    const unsigned seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (int k = 0; k < 24; ++k) {
        const double angle = uniform(random, 0, 2 * std::numbers::pi);
        const Vec3 way(std::cos(angle), std::sin(angle), 0);
        // Where the straight cuts open the wall, their own walls are touched first or last.
        if (std::min(std::abs(way.x), std::abs(way.y)) < 0.45)
            continue;
        const Vec3 start(20, 15, -2);
        EXPECT_NEAR(stock.way(cutterOf("flat:d=4"), start, start + way * 15.0), 11 - 2, kTolerance) << angle;
    }
}

TEST(StockContact, ThroughTheFloorThereIsNothing) {
    const Cutter mill = cutterOf("flat:d=8");
    const CutStock stock({{straightMotion({20, 15, -12}, {20, 16, -12}), &mill}});
    EXPECT_EQ(stock.way(cutterOf("ball:d=3"), {20, 15, 5}, {20, 15, -20}), kNever);
}

TEST(StockContact, IsLostWhereTheWayLeavesTheStock) {
    const Cutter mill = cutterOf("flat:d=8");
    const CutStock stock({{straightMotion({20, -10, -5}, {20, 40, -5}), &mill}});
    const Cutter probe = cutterOf("flat:d=4");
    EXPECT_NEAR(stock.wayToFree(probe, {22.63, 15, -3}, {12, 15, -3}), 0.63, kTolerance);
    EXPECT_NEAR(stock.wayToFree(probe, {10, 15, -1.7}, {10, 15, 5}), 1.7, kTolerance);
    // Across the slot the tool becomes free, although it touches again at the other wall.
    EXPECT_NEAR(stock.wayToFree(probe, {23, 15, -3}, {5, 15, -3}), 1, kTolerance);
    EXPECT_EQ(stock.wayToFree(probe, {10, 15, -3}, {10, 15, -1}), kNever);
    EXPECT_NEAR(stock.wayToFree(probe, {20, 15, 3}, {20, 15, 5}), 0, kTolerance);
}

constexpr double kColumns = 0.04; ///< mm between the columns of the brute-force search

/// The times at which a motion is within `reach` of a position in plan.
std::pair<double, double> timesNear(const Vec2& place, const Vec3& start, const Vec3& end, double reach) {
    const Vec2 way = Vec2(end) - Vec2(start);
    const Vec2 there = place - Vec2(start);
    const double length = glm::length(way);
    if (length == 0)
        return glm::length(there) <= reach ? std::pair(0.0, 1.0) : std::pair(1.0, 0.0);
    const double along = glm::dot(there, way) / length;
    const double across2 = glm::dot(there, there) - along * along;
    const double half = std::sqrt(std::max(0.0, reach * reach - across2));
    if (across2 > reach * reach)
        return {1, 0};
    return {std::max(0.0, (along - half) / length), std::min(1.0, (along + half) / length)};
}

/// Tests dense columns at dense times: the result is never early, and late by at most the distance between
/// columns.
double bruteForceWay(const CutStock& stock, const Cutter& cutter, const Vec3& start, const Vec3& end) {
    constexpr int kTimes = 400;
    const double reach = cutter.radius();
    double best = kNever;
    const Vec2 lo = glm::max(glm::min(Vec2(start), Vec2(end)) - reach, Vec2(0));
    const Vec2 hi = glm::min(glm::max(Vec2(start), Vec2(end)) + reach, Vec2(kStock.width, kStock.depth));
    for (double y = lo.y; y <= hi.y; y += kColumns)
        for (double x = lo.x; x <= hi.x; x += kColumns) {
            const auto [from, to] = timesNear({x, y}, start, end, reach);
            if (from > to || from >= best)
                continue;
            double height = 0;
            for (const PastCut& past : stock.cuts)
                height = std::min(height, envelope(*past.cutter, past.motion, x, y));
            if (height <= -kStock.height || height < std::min(start.z, end.z))
                continue;
            const auto touches = [&](double time) {
                const Vec3 tip = start + (end - start) * time;
                return tip.z + cutter.height(std::min(reach, std::hypot(x - tip.x, y - tip.y))) <= height;
            };
            for (int k = 0; k <= kTimes; ++k) {
                double late = from + (to - from) * k / kTimes;
                if (!touches(late))
                    continue;
                double early = from + (to - from) * std::max(0, k - 1) / kTimes;
                for (int halving = 0; halving < 24 && k > 0; ++halving) {
                    const double middle = (early + late) / 2;
                    (touches(middle) ? late : early) = middle;
                }
                best = std::min(best, late);
                break;
            }
        }
    return best * glm::distance(start, end);
}

/// The height of the tool at a position above the stock at a column; negative if it is in the stock.
double gapAt(const CutStock& stock, const Cutter& cutter, const Vec3& tip, const Vec2& column) {
    double height = 0;
    for (const PastCut& past : stock.cuts)
        height = std::min(height, envelope(*past.cutter, past.motion, column.x, column.y));
    const bool beside = column.x < 0 || column.y < 0 || column.x > kStock.width || column.y > kStock.depth;
    const double radius = glm::distance(column, Vec2(tip));
    if (beside || radius > cutter.radius() || height <= -kStock.height)
        return kNever;
    return tip.z + cutter.height(radius) - height;
}

/// Whether the tool at a position is in the stock: tests columns around it and along its rim, refined where
/// the gap is smallest.
bool isInStock(const CutStock& stock, const Cutter& cutter, const Vec3& tip) {
    struct Column {
        Vec2 at;
        double gap;
    };
    const auto column = [&](const Vec2& at) { return Column{at, gapAt(stock, cutter, tip, at)}; };
    std::vector<Column> columns;
    const auto addSquare = [&](const Vec2& middle, double half, double spacing) {
        const int n = static_cast<int>(half / spacing);
        for (int j = -n; j <= n; ++j)
            for (int i = -n; i <= n; ++i)
                columns.push_back(column(middle + Vec2(i, j) * spacing));
    };
    addSquare(Vec2(tip), cutter.radius(), kColumns);
    constexpr int kOfRim = 2000;
    for (int k = 0; k < kOfRim; ++k)
        for (const double inside : {1e-9, 1e-3, 4e-3}) {
            const double angle = 2 * std::numbers::pi * k / kOfRim;
            columns.push_back(
                column(Vec2(tip) + Vec2(std::cos(angle), std::sin(angle)) * (cutter.radius() - inside)));
        }
    constexpr std::size_t kNearest = 30;
    for (const double spacing : {kColumns, kColumns / 8, kColumns / 64}) {
        std::ranges::sort(columns, {}, &Column::gap);
        if (columns.front().gap <= 0)
            return true;
        const std::vector<Column> nearest(columns.begin(), columns.begin() + kNearest);
        for (const Column& near : nearest)
            addSquare(near.at, 2 * spacing, spacing / 8);
    }
    return std::ranges::min(columns, {}, &Column::gap).gap <= 0;
}

TEST(StockContact, AgreesWithBruteForce) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Cutter probes[] = {cutterOf("flat:d=3"), cutterOf("ball:d=4"), cutterOf("bull:d=4,r=1")};
    int touched = 0;
    for (int trial = 0; trial < 12; ++trial) {
        SCOPED_TRACE(testing::Message() << "trial " << trial);
        std::vector<Cutter> mills;
        for (const char* shape : {"flat", "ball", "bull"})
            mills.push_back(randomCutter(random, shape));
        std::vector<PastCut> cuts;
        for (std::size_t k = 0; k < 5; ++k) {
            const Vec3 from(uniform(random, -5, 45), uniform(random, -5, 35), uniform(random, -7, -1));
            const Vec3 to(uniform(random, -5, 45), uniform(random, -5, 35), uniform(random, -7, -1));
            cuts.push_back({straightMotion(from, to), &mills[k % mills.size()]});
        }
        const CutStock stock(cuts);
        const Cutter& probe = probes[trial % 3];
        const Vec3 start(uniform(random, -3, 43), uniform(random, -3, 33), uniform(random, 0.5, 4));
        Vec3 end(uniform(random, -3, 43), uniform(random, -3, 33), uniform(random, -8, -2));
        if (trial % 4 == 0)
            end = Vec3(start.x, start.y, -8);
        const double way = stock.way(probe, start, end);
        EXPECT_LE(way, bruteForceWay(stock, probe, start, end) + kTolerance);
        if (way == kNever)
            continue;
        const double length = glm::distance(start, end);
        EXPECT_TRUE(std::ranges::any_of(std::array{1.0, 2.0, 4.0, 10.0},
                                        [&](double tolerances) {
                                            const double further =
                                                std::min(length, way + tolerances * kTolerance);
                                            return isInStock(stock, probe,
                                                             start + (end - start) * (further / length));
                                        }))
            << "after " << way;
        ++touched;
    }
    EXPECT_GT(touched, 2);
}

} // namespace
} // namespace proveout
