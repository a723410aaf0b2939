// SPDX-License-Identifier: GPL-3.0-or-later
// Compares averages, lines and quantiles with their closed forms.
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <rapidcheck/gtest.h>

#include "core/study/averages.h"

namespace proveout {
namespace {

/// A sawtooth as in the paper's Fig. 10: 0, 1, …, period - 1, 0, 1, …
std::vector<Vec2> saw(std::size_t points, std::size_t period) {
    std::vector<Vec2> out;
    for (std::size_t k = 0; k < points; ++k)
        out.emplace_back(static_cast<double>(k + 1), static_cast<double>(k % period));
    return out;
}

TEST(WindowAverages, OfASawWithTheWindowAsPeriodAreLevel) {
    const auto averages = windowAverages(saw(100, 20), 20);
    ASSERT_EQ(averages.size(), 5U);
    for (std::size_t k = 0; k < averages.size(); ++k) {
        EXPECT_DOUBLE_EQ(averages[k].x, 20.0 * static_cast<double>(k) + 10.5); // mean of 20k + 1 … 20k + 20
        EXPECT_DOUBLE_EQ(averages[k].y, 9.5);
    }
}

TEST(WindowAverages, TheLastWindowMayBeShort) {
    const auto averages = windowAverages(saw(23, 100), 20);
    ASSERT_EQ(averages.size(), 2U);
    EXPECT_DOUBLE_EQ(averages[1].y, 21); // 20, 21, 22
    EXPECT_TRUE(windowAverages({}, 20).empty());
}

RC_GTEST_PROP(WindowAverages, KeepTheSum, ()) {
    const auto values = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-1000, 1000));
    const auto window = static_cast<std::size_t>(*rc::gen::inRange(1, 30));
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < values.size(); ++k)
        points.emplace_back(static_cast<double>(k), values[k]);
    double sum = 0;
    std::size_t place = 0;
    for (const Vec2& average : windowAverages(points, window)) {
        const std::size_t count = std::min(window, values.size() - place);
        sum += average.y * static_cast<double>(count);
        place += count;
    }
    RC_ASSERT(std::abs(sum - std::accumulate(values.begin(), values.end(), 0.0)) < 1e-6);
}

TEST(StraightLine, GoesThroughPointsOnALine) {
    const std::vector<Vec2> points{{5, 13}, {1, 5}, {3, 9}};
    const auto line = straightLine(points);
    ASSERT_EQ(line.size(), 2U);
    EXPECT_NEAR(line[0].x, 1, 1e-12);
    EXPECT_NEAR(line[0].y, 5, 1e-12);
    EXPECT_NEAR(line[1].x, 5, 1e-12);
    EXPECT_NEAR(line[1].y, 13, 1e-12);
}

TEST(StraightLine, OfThreePointsIsTheTextbookOne) {
    // y = 1/2 x + 1/6 over (0, 0), (1, 1), (2, 1)
    const auto line = straightLine(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 1}});
    ASSERT_EQ(line.size(), 2U);
    EXPECT_NEAR(line[0].y, 1.0 / 6, 1e-12);
    EXPECT_NEAR(line[1].y, 7.0 / 6, 1e-12);
}

TEST(StraightLine, NeedsTwoPlaces) {
    EXPECT_TRUE(straightLine({}).empty());
    EXPECT_TRUE(straightLine(std::vector<Vec2>{{1, 2}}).empty());
    EXPECT_TRUE(straightLine(std::vector<Vec2>{{1, 2}, {1, 3}}).empty());
}

TEST(Quantile, LiesBetweenItsNeighbours) {
    EXPECT_DOUBLE_EQ(quantile({3, 1, 2}, 0.5), 2);
    EXPECT_DOUBLE_EQ(quantile({4, 1, 2, 3}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(quantile({1, 2, 3, 4, 5}, 0.25), 2);
    EXPECT_DOUBLE_EQ(quantile({7}, 0.75), 7);
    EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Measured, SpreadIsThatOfTheMiddleHalf) {
    const Measured nine = measured({100, 101, 102, 103, 104, 105, 106, 107, 900});
    EXPECT_DOUBLE_EQ(nine.median, 104);
    EXPECT_DOUBLE_EQ(nine.spread, 4.0 / 104);
}

} // namespace
} // namespace proveout
