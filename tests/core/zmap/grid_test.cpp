// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "core/zmap/zmap.h"

namespace proveout {
namespace {

using testing::HasSubstr;

TEST(MakeGrid, AdjustsTheSpacingSoThatItDividesTheStock) {
    const Grid grid = makeGrid({{1, 2, 3}, 10, 7.1, 5}, 0.3).value();
    EXPECT_EQ(grid.nx, 34);
    EXPECT_EQ(grid.ny, 25);
    EXPECT_DOUBLE_EQ(grid.x(grid.nx - 1), 11);
    EXPECT_DOUBLE_EQ(grid.y(grid.ny - 1), 9.1);
    EXPECT_DOUBLE_EQ(grid.x(0), 1);
}

TEST(MakeGrid, RefusesWhatIsNoSpacing) {
    const StockBox stock{{0, 0, 0}, 100, 80, 20};
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const double spacing : {0.0, -1.0, kNan, std::numeric_limits<double>::infinity()}) {
        const auto grid = makeGrid(stock, spacing);
        ASSERT_FALSE(grid.has_value()) << spacing;
        EXPECT_STREQ(grid.error()[0].id, "grid-spacing-bad");
    }
}

TEST(MakeGrid, RefusesStocksThatAreNone) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const StockBox& stock : {StockBox{{0, 0, 0}, 0, 80, 20}, StockBox{{0, 0, 0}, 100, -80, 20},
                                  StockBox{{0, 0, 0}, 100, 80, kNan}, StockBox{{0, 0, 0}, 1e300, 80, 20},
                                  StockBox{{kNan, 0, 0}, 100, 80, 20}})
        EXPECT_FALSE(makeGrid(stock, 1).has_value());
}

/// Even the coarsest grid of such a stock has millions of points: a mesh file of a kilobyte needed gigabytes.
TEST(MakeGrid, RefusesStocksThatAreTooNarrow) {
    for (const StockBox& stock : {StockBox{{0, 0, 0}, 1e7, 1, 20}, StockBox{{0, 0, 0}, 0.01, 2000, 20}}) {
        const auto grid = makeGrid(stock, 1);
        ASSERT_FALSE(grid.has_value());
        EXPECT_STREQ(grid.error()[0].id, "stock-size-narrow");
    }
    EXPECT_TRUE(makeGrid({{0, 0, 0}, 20'000, 0.2, 20}, 0.2).has_value());
}

TEST(MakeGrid, RefusesCornersAndSpacingsThatRoundingWouldEat) {
    const auto far = makeGrid({{2e7, 0, 0}, 100, 80, 20}, 1);
    ASSERT_FALSE(far.has_value());
    EXPECT_STREQ(far.error()[0].id, "stock-origin-bad");
    EXPECT_TRUE(makeGrid({{1e7, -1e7, 0}, 100, 80, 20}, 1).has_value());
    const auto lost = makeGrid({{1e7, 0, 0}, 1e-8, 1e-8, 20}, 1e-9);
    ASSERT_FALSE(lost.has_value());
    EXPECT_STREQ(lost.error()[0].id, "grid-lost-in-rounding");
    EXPECT_FALSE(makeGrid({{0, 0, 0}, 1e-299, 1e-299, 20}, 1e-300).has_value());
}

TEST(MakeGrid, RefusesSpacingsWithoutACell) {
    const auto grid = makeGrid({{0, 0, 0}, 100, 0.4, 20}, 1);
    ASSERT_FALSE(grid.has_value());
    EXPECT_STREQ(grid.error()[0].id, "grid-too-coarse");
    EXPECT_THAT(message(grid.error()[0]), HasSubstr("0.4"));
}

/// The number before the " mm" that ends a sentence.
double lastNumber(const std::string& sentence) {
    const std::size_t unit = sentence.rfind(" mm");
    const std::size_t before = sentence.rfind(' ', unit - 1);
    return std::stod(sentence.substr(before + 1, unit - before - 1));
}

TEST(MakeGrid, ProposesTheFinestSpacingThatAnIndexHolds) {
    const StockBox stock{{0, 0, 0}, 2000, 1000, 20};
    for (const double spacing : {1e-9, 1e-300, 1e-3, 5e-324}) {
        const auto grid = makeGrid(stock, spacing);
        ASSERT_FALSE(grid.has_value());
        EXPECT_STREQ(grid.error()[0].id, "grid-too-fine");
        const double proposed = lastNumber(message(grid.error()[0]));
        EXPECT_TRUE(makeGrid(stock, proposed).has_value()) << message(grid.error()[0]);
        EXPECT_FALSE(makeGrid(stock, proposed * 0.98).has_value()) << message(grid.error()[0]);
    }
}

TEST(CheckMemory, RefusesWithTheFigureAndTheFinestSpacingThatFits) {
    const StockBox stock{{0, 0, 0}, 2000, 1000, 20};
    const Grid grid = makeGrid(stock, 0.1).value();
    EXPECT_TRUE(checkMemory(stock, grid, 1e12).has_value());
    const auto refused = checkMemory(stock, grid, 1e8);
    ASSERT_FALSE(refused.has_value());
    const std::string sentence = message(refused.error()[0]);
    EXPECT_THAT(sentence, HasSubstr("812 MB"));
    EXPECT_THAT(sentence, HasSubstr("100 MB"));
    const double proposed = lastNumber(sentence);
    EXPECT_TRUE(checkMemory(stock, makeGrid(stock, proposed).value(), 1e8).has_value()) << sentence;
    EXPECT_FALSE(checkMemory(stock, makeGrid(stock, proposed * 0.9).value(), 1e8).has_value()) << sentence;
}

TEST(CheckMemory, CountsWhatIsMadeOfEachPoint) {
    const StockBox stock{{0, 0, 0}, 1000, 1000, 20};
    const Grid grid = makeGrid(stock, 1).value();
    EXPECT_TRUE(checkMemory(stock, grid, 5e7).has_value());
    const auto refused = checkMemory(stock, grid, 5e7, 80);
    ASSERT_FALSE(refused.has_value());
    const double proposed = lastNumber(message(refused.error()[0]));
    EXPECT_TRUE(checkMemory(stock, makeGrid(stock, proposed).value(), 5e7, 80).has_value());
    EXPECT_FALSE(checkMemory(stock, makeGrid(stock, proposed * 0.9).value(), 5e7, 80).has_value());
}

TEST(CheckMemory, ProposesNothingWhereNothingFits) {
    const StockBox stock{{0, 0, 0}, 100, 100, 20};
    const auto refused = checkMemory(stock, makeGrid(stock, 1).value(), 10);
    ASSERT_FALSE(refused.has_value());
    EXPECT_STREQ(refused.error()[0].id, "memory-too-small");
}

TEST(ZmapBytes, CountsAtLeastTheHeightsThemselves) {
    const Grid grid = makeGrid({{0, 0, 0}, 100, 80, 20}, 0.1).value();
    EXPECT_GE(zmapBytes(grid), 4.0 * grid.nx * grid.ny);
    EXPECT_LE(zmapBytes(grid), 4.0 * 1.2 * grid.nx * grid.ny);
}

} // namespace
} // namespace proveout
