// SPDX-License-Identifier: GPL-3.0-or-later
// Rims of saved stock, as they come with it.
#include "core/zmap/turned_rims.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "core/zmap/map_top.h"
#include "core/zmap/saved_stock.h"
#include "tests/core/random_rims.h"
#include "tests/core/random_test.h"

namespace proveout {
namespace {

class TurnedRims : public RandomTest {
protected:
    /// 3 × 2 tiles with random heights and rims.
    ZMapSnapshot randomMap() {
        const StockBox stock{{-5, 7, 12}, 150.5, 91.1, 20};
        ZMap zmap(stock, makeGrid(stock, 0.9).value());
        std::uniform_real_distribution<float> height(zmap.floor(), 0);
        for (std::size_t index = 0; index < zmap.tileCount(); ++index) {
            const IndexRect rect = zmap.tileRect(index);
            for (int j = 0; j < rect.height(); ++j)
                for (int i = 0; i < rect.width(); ++i)
                    zmap.tileForWriting(index).at(i, j) = height(random);
        }
        ZMapSnapshot map = zmap.snapshot();
        map.setRims(randomRims(random, map));
        return map;
    }
    static ZMapSnapshot turned(const ZMapSnapshot& map, StockTurn turn) {
        const auto body = savedStock(map, 0.9, turn).value();
        const Grid grid = makeGrid(body->box(), 0.9).value();
        ZMapSnapshot result = body->uncut(body->box(), grid).zmap.snapshot();
        result.setRims(body->rims(body->box(), grid));
        return result;
    }
};

TEST_F(TurnedRims, FourQuartersGiveTheSameBits) {
    const ZMapSnapshot map = randomMap();
    EXPECT_GT(countOf(map.rims()), 1000U);
    EXPECT_GT(unseenRibs(map.rims()), 200U);
    ZMapSnapshot quarters = map;
    for (const StockTurn turn :
         {StockTurn::quarter, StockTurn::half, StockTurn::threeQuarters, StockTurn::none}) {
        quarters = turned(quarters, StockTurn::quarter);
        EXPECT_TRUE(sameRims(turned(map, turn).rims(), quarters.rims()));
    }
    EXPECT_TRUE(sameRims(quarters.rims(), map.rims()));
}

TEST_F(TurnedRims, AreAtTheSamePlacesOfThePart) {
    const ZMapSnapshot map = randomMap();
    const ZMapSnapshot quarter = turned(map, StockTurn::quarter);
    const Grid& grid = quarter.grid();
    ASSERT_EQ(countOf(quarter.rims()), countOf(map.rims()));
    const MapTop top(map);
    for (std::size_t tile = 0; tile < quarter.tileCount(); ++tile) {
        if (quarter.rims()[tile] == nullptr)
            continue;
        const IndexRect rect = quarter.tileRect(tile);
        for (const Rim& rim : quarter.rims()[tile]->rims) {
            const RimEdge edge = RimEdge::of(rim.edge);
            const int i = rect.i0 + edge.i;
            const int j = rect.j0 + edge.j;
            // x of the part is along y now, and y against x.
            const int oldI = j;
            const int oldJ = grid.nx - 1 - i - (edge.alongY ? 0 : 1);
            const auto oldTile =
                static_cast<std::size_t>(oldJ / Tile::kSize * map.tilesX() + oldI / Tile::kSize);
            const Rim* before =
                top.rims(oldTile)->find({oldI % Tile::kSize, oldJ % Tile::kSize, !edge.alongY});
            ASSERT_NE(before, nullptr);
            EXPECT_NEAR(rim.fraction(true), edge.alongY ? before->fraction(true) : 1 - before->fraction(true),
                        1.0 / 65536);
            EXPECT_EQ(rim.normal(), Vec2(-before->normal().y, before->normal().x));
            EXPECT_EQ(rim.top, before->top);
            EXPECT_EQ(rim.sides, before->sides);
        }
    }
}

/// The part on the left of a wall through the stock, and on a ledge.
TEST_F(TurnedRims, AreThoseOfThroughWallsAfterAFlip) {
    const StockBox stock{{0, 0, 0}, 90, 80, 10};
    ZMap zmap(stock, makeGrid(stock, 1).value());
    constexpr int kLast = 69; // of the points on the left; the next tile begins at 64
    for (std::size_t index = 0; index < zmap.tileCount(); ++index) {
        const IndexRect rect = zmap.tileRect(index);
        for (int j = 0; j < rect.height(); ++j)
            for (int i = 0; i < rect.width(); ++i)
                zmap.tileForWriting(index).at(i, j) = rect.i0 + i <= kLast ? 0 : zmap.floor();
    }
    ZMapSnapshot map = zmap.snapshot();
    const Rim through{
        RimEdge{kLast - 64, 3, false}.index(), 20'000, 30'000, RimSides::both, 0, -10, -32'767, 0};
    Rim ledge = through;
    ledge.edge = RimEdge{kLast - 64, 4, false}.index();
    ledge.bottom = -9;
    RimMap rims(map.tileCount());
    rims.edit(1) = std::make_shared<RimTile>(RimTile{{through, ledge}});
    map.setRims(rims);
    for (const StockFlip flip : {StockFlip::aboutX, StockFlip::aboutY}) {
        const auto body = savedStock(map, 1, StockTurn::none, flip).value();
        const RimMap after = body->rims(body->box(), makeGrid(body->box(), 1).value());
        ASSERT_EQ(countOf(after), 1U);
        const bool aboutX = flip == StockFlip::aboutX;
        const std::size_t tile = aboutX ? 3 : 0; // row 77 of 81, or column 20 of 91
        ASSERT_NE(after[tile], nullptr);
        const Rim& rim = after[tile]->rims.front();
        const RimEdge expected = aboutX ? RimEdge{kLast - 64, 77 - 64, false} : RimEdge{20, 3, false};
        EXPECT_EQ(rim.edge, expected.index());
        EXPECT_EQ(rim.highPlace, aboutX ? 30'000 : 65'535 - 30'000);
        EXPECT_EQ(rim.lowPlace, rim.highPlace);
        EXPECT_EQ(rim.top, 0);
        EXPECT_EQ(rim.bottom, -10);
        EXPECT_EQ(rim.normalX, aboutX ? -32'767 : 32'767);
    }
}

/// Of what is unknown of a tile, the points are in others then.
TEST_F(TurnedRims, UnknownTilesMakeAllUnknownThatHaveTheirPoints) {
    ZMapSnapshot map = randomMap(); // 168 × 102 points
    RimMap rims(map.tileCount());
    rims.edit(2) =
        std::make_shared<const RimTile>(RimTile{{}, true}); // the last 40 columns of the first rows
    map.setRims(rims);
    const auto unknown = [](const ZMapSnapshot& turned) {
        std::vector<std::size_t> tiles;
        for (std::size_t tile = 0; tile < turned.tileCount(); ++tile)
            if (turned.rims()[tile] != nullptr && turned.rims()[tile]->areUnknown)
                tiles.push_back(tile);
        return tiles;
    };
    EXPECT_EQ(unknown(turned(map, StockTurn::none)), (std::vector<std::size_t>{2}));
    EXPECT_EQ(unknown(turned(map, StockTurn::half)), (std::vector<std::size_t>{0, 3}));
    EXPECT_EQ(unknown(turned(map, StockTurn::quarter)), (std::vector<std::size_t>{4, 5}));
}

/// Between floors that are the old one, a rib stands on the new one as well.
TEST_F(TurnedRims, RibsBetweenThroughCutsRemainAfterAFlip) {
    const StockBox stock{{0, 0, 0}, 20, 10, 5};
    ZMap zmap(stock, makeGrid(stock, 1).value());
    for (int i = 5; i < 10; ++i) {
        zmap.tileForWriting(0).at(i, 3) = zmap.floor();
        zmap.tileForWriting(0).at(i, 4) = -3;
    }
    ZMapSnapshot map = zmap.snapshot();
    map.setRims(RimMap(1, std::make_shared<const RimTile>(RimTile{
                              {}, false, {RimEdge{7, 3, false}.index(), RimEdge{7, 4, false}.index()}})));
    const auto body = savedStock(map, 1, StockTurn::none, StockFlip::aboutX).value();
    const RimMap after = body->rims(body->box(), makeGrid(body->box(), 1).value());
    ASSERT_NE(after[0], nullptr);
    EXPECT_EQ(after[0]->unseenRibs, (std::vector<std::uint16_t>{RimEdge{7, 7, false}.index()}));
}

TEST_F(TurnedRims, AreUnknownOnAnotherGrid) {
    const ZMapSnapshot map = randomMap();
    const auto body = savedStock(map, 0.9).value();
    const auto expectUnknown = [&](const StockBox& box, double spacing) {
        const Grid grid = makeGrid(box, spacing).value();
        const RimMap rims = body->rims(box, grid);
        EXPECT_EQ(countOf(rims), 0U);
        EXPECT_EQ(unknownTiles(rims), tileCountOf(grid));
        const Diagnostics findings = body->uncut(box, grid).findings;
        EXPECT_TRUE(std::ranges::any_of(findings, [](const Diagnostic& finding) {
            return finding.id == std::string("stock-walls-lost");
        }));
    };
    expectUnknown(body->box(), 0.45);
    StockBox higher = body->box();
    higher.height += 1;
    expectUnknown(higher, 0.9);
    StockBox moved = body->box();
    moved.corner += Vec3(100.3, -20, 5);
    EXPECT_TRUE(sameRims(body->rims(moved, makeGrid(moved, 0.9).value()), map.rims()));
    EXPECT_TRUE(body->uncut(moved, makeGrid(moved, 0.9).value()).findings.empty());
}

TEST_F(TurnedRims, ThatAreNoneAreNotMissed) {
    ZMapSnapshot map = randomMap();
    map.setRims({});
    const auto body = savedStock(map, 0.9).value();
    const Grid finer = makeGrid(body->box(), 0.45).value();
    EXPECT_TRUE(body->rims(body->box(), finer).empty());
    EXPECT_TRUE(body->uncut(body->box(), finer).findings.empty());
}

TEST_F(TurnedRims, TheTopIsAStepAtThem) {
    const StockBox stock{{0, 0, 0}, 4, 3, 5};
    ZMap zmap(stock, makeGrid(stock, 1).value());
    for (int j = 0; j < 4; ++j)
        for (int i = 2; i < 5; ++i)
            zmap.tileForWriting(0).at(i, j) = -4;
    ZMapSnapshot map = zmap.snapshot();
    RimTile rims;
    // The wall is at x = 1.25 where y = 1, and leans over ground.
    rims.rims.push_back({RimEdge{1, 1, false}.index(), 16384, 16384, RimSides::both, 0, -4, inRimUnits(-0.8),
                         inRimUnits(0.6)});
    map.setRims(RimMap(1, std::make_shared<const RimTile>(rims)));
    const MapTop top(map);
    EXPECT_EQ(top.height({1.2499, 1}), 0);
    EXPECT_EQ(top.height({1.2501, 1}), -4);
    EXPECT_EQ(top.height({1.2507, 1.001}), 0); // the wall is at 1.25075
    EXPECT_EQ(top.height({1.2508, 1.001}), -4);
    EXPECT_EQ(top.height({1.2493, 0.999}), -4);
    EXPECT_EQ(top.height({1.2492, 0.999}), 0);
    for (const double x : {0.0, 1.0, 2.0, 3.0})
        EXPECT_EQ(top.height({x, 1}), map.height(static_cast<int>(x), 1));
    EXPECT_NEAR(top.height({1.25, 2}), -1, 1e-9) << "nothing is known of that edge";
    EXPECT_NEAR(top.height({1.25, 1.5}), -1, 1e-9) << "nor within cells";
    EXPECT_FALSE(top.knowsWalls());
}

} // namespace
} // namespace proveout
