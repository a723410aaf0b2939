// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/surface/map_memory.h"

#include <gtest/gtest.h>
#include <limits>

namespace proveout {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

TEST(MapMemory, RefusesMapsThatTheGlobalMethodCannotCount) {
    const StockBox stock{{0, 0, 0}, 18'900, 18'999, 20};
    const Grid small = makeGrid({{0, 0, 0}, 18'000, 18'000, 20}, 1).value();
    const Grid large = makeGrid(stock, 1).value();
    DecimationParameters parameters;
    parameters.method = DecimationMethod::global;
    EXPECT_TRUE(checkMapMemory(stock, small, parameters, {}, kEndless));
    const auto refused = checkMapMemory(stock, large, parameters, {}, kEndless);
    ASSERT_FALSE(refused);
    EXPECT_STREQ(refused.error()[0].id, "method-map-too-large");
    parameters.method = DecimationMethod::lee;
    EXPECT_TRUE(checkMapMemory(stock, large, parameters, {}, kEndless));
}

TEST(MapMemory, CountsWhatIsAskedFor) {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::lee;
    const double surface = meshBytesPerPoint(parameters, {});
    EXPECT_GT(surface, 24) << "two triangles of three indices";
    const double solid = meshBytesPerPoint(parameters, {.schedule = false, .whole = true, .solid = true});
    EXPECT_GT(solid, surface);
    EXPECT_EQ(meshBytesPerPoint(parameters, {.schedule = false}), 0);
    parameters.period = 0;
    EXPECT_EQ(meshBytesPerPoint(parameters, {}), 0) << "nothing is ever decimated";
    parameters.period = 20;
    parameters.method = DecimationMethod::global;
    EXPECT_GT(meshBytesPerPoint(parameters, {}), surface);
    parameters.method = DecimationMethod::lee;
    const double whole = meshBytesPerPoint(parameters, {.schedule = false, .whole = true});
    parameters.method = DecimationMethod::certified;
    EXPECT_GT(meshBytesPerPoint(parameters, {.schedule = false, .whole = true}), whole)
        << "merging keeps what it merged";
    EXPECT_GT(meshBytesPerPoint(parameters, {.whole = true, .solid = true}), solid) << "the schedule as well";
}

TEST(MapMemory, OfASolidNothingButTheScheduleRemains) {
    DecimationParameters parameters;
    EXPECT_EQ(heldBytesPerPoint(parameters, {.schedule = false, .whole = true, .solid = true}), 0);
    EXPECT_GT(heldBytesPerPoint(parameters, {.schedule = false, .whole = true}), 24);
    EXPECT_GT(heldBytesPerPoint(parameters, {.whole = true, .solid = true}), 24);
    EXPECT_LE(heldBytesPerPoint(parameters, {.whole = true}), meshBytesPerPoint(parameters, {.whole = true}));
}

TEST(MapMemory, OfAWatchedSurfaceIsNotRequiredInAdvance) {
    const StockBox stock{Vec3(0), 2000, 1000, 40};
    const Grid grid = makeGrid(stock, 0.1).value();
    DecimationParameters parameters;
    const MapOutputs any{.schedule = false, .whole = true, .solid = true};
    const MapOutputs watched{.schedule = false, .whole = true, .solid = true, .watched = true};
    const double map = zmapBytes(grid);
    EXPECT_FALSE(checkMapMemory(stock, grid, parameters, any, 1.01 * map));
    EXPECT_TRUE(checkMapMemory(stock, grid, parameters, watched, 1.01 * map));
    EXPECT_FALSE(checkMapMemory(stock, grid, parameters, watched, 0.99 * map));
    EXPECT_LT(expectedMapBytes(grid, parameters, watched), 5e9);
    EXPECT_GT(mapBytes(grid, parameters, watched), 15e9) << "the forecast is still the worst";
    parameters.method = DecimationMethod::none; // every triangle remains
    EXPECT_FALSE(checkMapMemory(stock, grid, parameters, watched, 1.01 * map));
}

TEST(MapMemory, OfAWatchedScheduleIsTheMapsAndTheEmptyRegions) {
    const StockBox stock{Vec3(0), 2000, 1000, 40};
    const Grid grid = makeGrid(stock, 0.1).value();
    const MapOutputs watched{.watched = true};
    const double map = zmapBytes(grid);
    EXPECT_FALSE(checkMapMemory(stock, grid, {}, {}, 3 * map));
    EXPECT_TRUE(checkMapMemory(stock, grid, {}, watched, 3 * map));
    EXPECT_FALSE(checkMapMemory(stock, grid, {}, watched, 2 * map))
        << "the map of the last moment is held too";
    EXPECT_EQ(mapBytes(grid, {}, watched), mapBytes(grid, {}, {})) << "the forecast is still the worst";
    EXPECT_LT(expectedMapBytes(grid, {}, watched), 0.7 * mapBytes(grid, {}, watched));
}

TEST(MapMemory, CountsTheUncutMapOfAStockThatIsNoBox) {
    const Grid grid = makeGrid({Vec3(0), 100, 100, 20}, 0.1).value();
    const double box = mapBytes(grid, {}, {.schedule = false});
    EXPECT_NEAR(mapBytes(grid, {}, {.schedule = false, .shaped = true}), 2 * box, 0.05 * box);
}

TEST(MapMemory, OfAMapIsWhatIsComparedWithTheLimit) {
    const StockBox stock{{0, 0, 0}, 100, 100, 20};
    const Grid grid = makeGrid(stock, 0.1).value();
    const MapOutputs outputs{.schedule = false, .solid = true};
    const double bytes = mapBytes(grid, {}, outputs);
    EXPECT_TRUE(checkMapMemory(stock, grid, {}, outputs, bytes));
    EXPECT_FALSE(checkMapMemory(stock, grid, {}, outputs, bytes - 1));
}

} // namespace
} // namespace proveout
