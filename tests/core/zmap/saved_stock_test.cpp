// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/saved_stock.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

namespace proveout {
namespace {

constexpr double kSpacing = 0.7;

/// Random heights, some points empty.
ZMapSnapshot randomMap(std::uint_fast32_t seed, const StockBox& stock, double spacing = kSpacing) {
    std::mt19937 random(seed);
    ZMap zmap(stock, makeGrid(stock, spacing).value());
    std::uniform_real_distribution<float> height(zmap.floor(), 0);
    for (std::size_t index = 0; index < zmap.tileCount(); ++index) {
        Tile& tile = zmap.tileForWriting(index);
        const IndexRect rect = zmap.tileRect(index);
        for (int j = 0; j < rect.height(); ++j)
            for (int i = 0; i < rect.width(); ++i)
                tile.at(i, j) = random() % 9 == 0 ? zmap.floor() : height(random);
        tile.refreshMaximum();
    }
    return zmap.snapshot();
}

/// Points are either full or empty, so there are no undercuts.
ZMapSnapshot prism(std::uint_fast32_t seed, const StockBox& stock) {
    std::mt19937 random(seed);
    ZMap zmap(stock, makeGrid(stock, kSpacing).value());
    for (std::size_t index = 0; index < zmap.tileCount(); ++index) {
        Tile& tile = zmap.tileForWriting(index);
        const IndexRect rect = zmap.tileRect(index);
        for (int j = 0; j < rect.height(); ++j)
            for (int i = 0; i < rect.width(); ++i)
                tile.at(i, j) = random() % 3 == 0 ? zmap.floor() : 0;
        tile.refreshMaximum();
    }
    return zmap.snapshot();
}

UncutStock fromSaved(const ZMapSnapshot& map, StockTurn turn, StockFlip flip = StockFlip::none,
                     double spacing = kSpacing) {
    const auto body = savedStock(map, kSpacing, turn, flip).value();
    return body->uncut(body->box(), makeGrid(body->box(), spacing).value());
}

bool same(const ZMapSnapshot& a, const ZMapSnapshot& b) {
    return a.stock() == b.stock() && a.grid() == b.grid() &&
           a.sameHeights(b, {0, 0, a.grid().nx, a.grid().ny});
}

const StockBox kStock{{-5, 7, 12}, 83.5, 61.1, 20};

TEST(SavedStock, IsWhatItWasAndSharesItsTiles) {
    const ZMapSnapshot map = randomMap(1, kStock);
    const UncutStock uncut = fromSaved(map, StockTurn::none);
    EXPECT_TRUE(same(uncut.zmap.snapshot(), map));
    EXPECT_EQ(uncut.zmap.snapshot().tile(0), map.tile(0));
    EXPECT_TRUE(uncut.findings.empty());
}

TEST(SavedStock, KeepsItsHeightsAtAnotherPlace) {
    const ZMapSnapshot map = randomMap(2, kStock);
    const auto body = savedStock(map, kSpacing).value();
    StockBox there = body->box();
    there.corner += Vec3(100.3, -20, 5);
    const UncutStock uncut = body->uncut(there, makeGrid(there, kSpacing).value());
    EXPECT_EQ(uncut.zmap.stock().corner, there.corner);
    EXPECT_EQ(uncut.zmap.grid().x0, there.corner.x);
    EXPECT_EQ(uncut.zmap.snapshot().tile(0), map.tile(0));
}

TEST(SavedStock, FourQuartersAreOneWholeTurn) {
    for (std::uint_fast32_t seed = 1; seed <= 10; ++seed) {
        const ZMapSnapshot map = randomMap(seed, kStock);
        ZMapSnapshot now = map;
        for (int k = 0; k < 4; ++k)
            now = fromSaved(now, StockTurn::quarter).zmap.snapshot();
        EXPECT_TRUE(same(now, map)) << "seed " << seed;
        const ZMapSnapshot half = fromSaved(map, StockTurn::half).zmap.snapshot();
        const ZMapSnapshot quarter = fromSaved(map, StockTurn::quarter).zmap.snapshot();
        EXPECT_TRUE(same(fromSaved(quarter, StockTurn::quarter).zmap.snapshot(), half));
        EXPECT_TRUE(same(fromSaved(half, StockTurn::quarter).zmap.snapshot(),
                         fromSaved(map, StockTurn::threeQuarters).zmap.snapshot()));
        EXPECT_EQ(quarter.grid().nx, map.grid().ny);
        EXPECT_NEAR(quarter.volume(), map.volume(), 1e-6);
    }
}

TEST(SavedStock, TurnsCounterClockwise) {
    const ZMapSnapshot map = randomMap(3, kStock);
    const ZMapSnapshot turned = fromSaved(map, StockTurn::quarter).zmap.snapshot();
    // The lower left corner becomes the lower right one.
    EXPECT_EQ(turned.height(turned.grid().nx - 1, 0), map.height(0, 0));
    EXPECT_EQ(turned.height(0, 0), map.height(0, map.grid().ny - 1));
}

TEST(SavedStock, FlippedTwiceIsTheSameWhereNothingIsUnderneath) {
    for (std::uint_fast32_t seed = 1; seed <= 10; ++seed)
        for (const StockFlip flip : {StockFlip::aboutX, StockFlip::aboutY}) {
            const ZMapSnapshot map = prism(seed, kStock);
            const UncutStock once = fromSaved(map, StockTurn::none, flip);
            EXPECT_TRUE(once.findings.empty());
            EXPECT_TRUE(same(fromSaved(once.zmap.snapshot(), StockTurn::none, flip).zmap.snapshot(), map))
                << "seed " << seed;
            const bool aboutX = flip == StockFlip::aboutX;
            EXPECT_EQ(once.zmap.snapshot().height(3, 5),
                      map.height(aboutX ? 3 : map.grid().nx - 4, aboutX ? map.grid().ny - 6 : 5));
        }
}

TEST(SavedStock, WhatWasCutIsAirUnderTheFlippedStock) {
    const StockBox box{{0, 0, 0}, 40, 30, 10};
    ZMap zmap(box, makeGrid(box, 0.5).value());
    Tile& tile = zmap.tileForWriting(0);
    for (int j = 20; j < 30; ++j)
        for (int i = 10; i < 40; ++i)
            tile.at(i, j) = -4; // 30 × 10 points of 0.5 mm
    tile.refreshMaximum();
    const auto body = savedStock(zmap.snapshot(), 0.5, StockTurn::quarter, StockFlip::aboutX).value();
    EXPECT_EQ(body->box(), (StockBox{{0, 0, 0}, 30, 40, 10}));
    const UncutStock uncut = body->uncut(body->box(), makeGrid(body->box(), 0.5).value());
    ASSERT_EQ(uncut.findings.size(), 1U);
    const Diagnostic& reported = uncut.findings.front();
    EXPECT_EQ(reported.id, std::string("stock-undercut"));
    EXPECT_TRUE(reported.unverified);
    EXPECT_NEAR(std::stod(reported.arguments[0]), 300 * 0.25 * 4, 1e-9);
    EXPECT_NEAR(std::stod(reported.arguments[1]), 4, 1e-9);
    EXPECT_NEAR(std::stod(reported.arguments[4]), -6, 1e-9);
    // Flipped around X the pocket is from Y15.5 to Y20; after a quarter turn to the left, from X10 to X14.5.
    const double x = std::stod(reported.arguments[2]);
    const double y = std::stod(reported.arguments[3]);
    EXPECT_TRUE(x >= 30 - 20 && x <= 30 - 15) << x;
    EXPECT_TRUE(y >= 5 && y <= 20) << y;
}

TEST(SavedStock, IsAsHighAsWhatIsLeftWhenFlipped) {
    const StockBox box{{0, 0, 0}, 20, 20, 10};
    ZMap zmap(box, makeGrid(box, 0.5).value());
    Tile& tile = zmap.tileForWriting(0);
    for (int j = 0; j < 41; ++j)
        for (int i = 0; i < 41; ++i)
            tile.at(i, j) = -1.5; // faced
    tile.refreshMaximum();
    const auto body = savedStock(zmap.snapshot(), 0.5, StockTurn::none, StockFlip::aboutY).value();
    EXPECT_EQ(body->box().height, 8.5);
    const UncutStock uncut = body->uncut(body->box(), makeGrid(body->box(), 0.5).value());
    EXPECT_TRUE(uncut.findings.empty());
    EXPECT_DOUBLE_EQ(uncut.zmap.snapshot().volume(), 20 * 20 * 8.5);
}

/// The surface interpolated between the points.
double bilinear(const ZMapSnapshot& map, double x, double y) {
    const Grid& grid = map.grid();
    const double u = std::clamp((x - grid.x0) / grid.hx, 0.0, grid.nx - 1.0);
    const double v = std::clamp((y - grid.y0) / grid.hy, 0.0, grid.ny - 1.0);
    const int i = std::min(static_cast<int>(u), grid.nx - 2);
    const int j = std::min(static_cast<int>(v), grid.ny - 2);
    return std::lerp(std::lerp(double{map.height(i, j)}, double{map.height(i + 1, j)}, u - i),
                     std::lerp(double{map.height(i, j + 1)}, double{map.height(i + 1, j + 1)}, u - i), v - j);
}

TEST(SavedStock, IsNowhereLowerOnAnotherGrid) {
    const ZMapSnapshot map = randomMap(5, kStock);
    for (const double spacing : {0.2, 0.31, 0.5, 0.69, 0.71, 1.0, 1.4, 3.3, 20.0}) {
        SCOPED_TRACE(fmt::format("spacing {}", spacing));
        const UncutStock uncut = fromSaved(map, StockTurn::none, StockFlip::none, spacing);
        const ZMapSnapshot other = uncut.zmap.snapshot();
        for (int j = 0; j < map.grid().ny; ++j)
            for (int i = 0; i < map.grid().nx; ++i)
                ASSERT_GE(bilinear(other, map.grid().x(i), map.grid().y(j)), map.height(i, j) - 1e-5)
                    << i << ' ' << j;
        ASSERT_EQ(uncut.findings.size(), 1U);
        EXPECT_EQ(uncut.findings.front().id, std::string("stock-resampled"));
        EXPECT_EQ(uncut.findings.front().severity, Severity::note);
    }
}

TEST(SavedStock, IsTheSameSurfaceOnAGridThatHoldsAllItsPoints) {
    const StockBox box{{0, 0, 0}, 40, 30, 10};
    const ZMapSnapshot map = randomMap(6, box, 1);
    for (const int part : {2, 3, 5}) {
        const auto body = savedStock(map, 1).value();
        const UncutStock uncut = body->uncut(box, makeGrid(box, 1.0 / part).value());
        EXPECT_TRUE(uncut.findings.empty());
        const ZMapSnapshot finer = uncut.zmap.snapshot();
        for (int j = 0; j < finer.grid().ny; ++j)
            for (int i = 0; i < finer.grid().nx; ++i)
                ASSERT_NEAR(finer.height(i, j), bilinear(map, finer.grid().x(i), finer.grid().y(j)), 1e-5)
                    << part << ": " << i << ' ' << j;
    }
}

TEST(SavedStock, NothingLeftCannotBeFlipped) {
    const StockBox box{{0, 0, 0}, 4, 3, 10};
    ZMap zmap(box, makeGrid(box, 1).value());
    zmap.tileForWriting(0).heights.fill(zmap.floor());
    EXPECT_EQ(savedStock(zmap.snapshot(), 1, StockTurn::none, StockFlip::aboutX).error().front().id,
              std::string("stock-nothing-left"));
}

} // namespace
} // namespace proveout
