// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/zmap.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace proveout {
namespace {

const StockBox kStock{{0, 0, 0}, 149, 99, 20};

ZMap freshMap() {
    return {kStock, makeGrid(kStock, 1).value()};
}

std::vector<float> allHeights(const ZMapSnapshot& moment) {
    std::vector<float> heights;
    for (int j = 0; j < moment.grid().ny; ++j) {
        for (int i = 0; i < moment.grid().nx; ++i)
            heights.push_back(moment.height(i, j));
    }
    return heights;
}

/// Sets a height like the cutting kernels.
void write(ZMap& zmap, int i, int j, float height) {
    const auto tile = static_cast<std::size_t>(j / Tile::kSize * zmap.tilesX() + i / Tile::kSize);
    zmap.tileForWriting(tile).at(i % Tile::kSize, j % Tile::kSize) = height;
}

TEST(ZMap, BeginsUncutWithTheFloorOutside) {
    const ZMap zmap = freshMap();
    ASSERT_EQ(zmap.tileCount(), 6U);
    const ZMapSnapshot moment = zmap.snapshot();
    for (const float height : allHeights(moment))
        EXPECT_EQ(height, 0.0F);
    EXPECT_EQ(moment.tileRect(5), (IndexRect{128, 64, 150, 100}));
    EXPECT_EQ(moment.tile(5)->at(22, 0), -20.0F);
    EXPECT_EQ(moment.tile(5)->at(0, 36), -20.0F);
    EXPECT_DOUBLE_EQ(moment.volume(), 149.0 * 99 * 20);
}

TEST(ZMap, CutsOnlyWhatNoMomentHolds) {
    ZMap zmap = freshMap();
    EXPECT_EQ(&zmap.tile(0), &zmap.tile(1)) << "uncut tiles are one";
    write(zmap, 2, 3, -1);
    EXPECT_NE(&zmap.tile(0), &zmap.tile(1));
    EXPECT_EQ(zmap.tile(1).at(2, 3), 0.0F);
    const Tile* before = &zmap.tile(0);
    write(zmap, 3, 3, -1);
    EXPECT_EQ(&zmap.tile(0), before) << "nobody shares the tile yet";
    const ZMapSnapshot moment = zmap.snapshot();
    write(zmap, 3, 3, -2);
    EXPECT_NE(&zmap.tile(0), before);
    EXPECT_EQ(moment.height(3, 3), -1.0F);
    const Tile* copied = &zmap.tile(0);
    write(zmap, 4, 4, -2);
    EXPECT_EQ(&zmap.tile(0), copied) << "one copy a moment";
}

TEST(ZMap, RandomWritesNeverChangeAMomentAndEqualPointersMeanEqualHeights) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        std::mt19937 random(seed);
        ZMap zmap = freshMap();
        std::vector<ZMapSnapshot> moments;
        std::vector<std::vector<float>> kept;
        for (int step = 0; step < 60; ++step) {
            for (unsigned k = random() % 4; k > 0; --k)
                write(zmap, static_cast<int>(random() % 150), static_cast<int>(random() % 100),
                      -static_cast<float>(random() % 20));
            if (random() % 8 == 0)
                zmap = ZMap(moments.empty() ? zmap.snapshot() : moments[random() % moments.size()]);
            moments.push_back(zmap.snapshot());
            kept.push_back(allHeights(moments.back()));
        }
        for (std::size_t m = 0; m < moments.size(); ++m) {
            EXPECT_EQ(allHeights(moments[m]), kept[m]);
            const ZMapSnapshot& other = moments[random() % moments.size()];
            for (std::size_t tile = 0; tile < moments[m].tileCount(); ++tile) {
                const bool shared = moments[m].tile(tile) == other.tile(tile);
                EXPECT_TRUE(!shared || moments[m].sameHeights(other, moments[m].tileRect(tile)));
            }
            const bool same = allHeights(moments[m]) == allHeights(other);
            EXPECT_EQ(moments[m].sameHeights(other, {0, 0, 150, 100}), same);
        }
    }
}

TEST(ZMap, SharesUntouchedTilesBetweenMoments) {
    ZMap zmap = freshMap();
    const ZMapSnapshot first = zmap.snapshot();
    write(zmap, 70, 10, -1);
    const ZMapSnapshot second = zmap.snapshot();
    for (std::size_t tile = 0; tile < 6; ++tile)
        EXPECT_EQ(first.tile(tile) == second.tile(tile), tile != 1) << tile;
}

TEST(ZMap, ContinuesFromAMomentWithoutChangingIt) {
    ZMap zmap = freshMap();
    write(zmap, 5, 5, -3);
    const ZMapSnapshot moment = zmap.snapshot();
    ZMap again(moment);
    write(again, 5, 5, -4);
    EXPECT_EQ(moment.height(5, 5), -3.0F);
    EXPECT_EQ(again.snapshot().height(5, 5), -4.0F);
}

TEST(ZMapSnapshot, ReadsRectanglesAcrossTiles) {
    ZMap zmap = freshMap();
    for (int j = 0; j < 100; ++j) {
        for (int i = 0; i < 150; ++i)
            write(zmap, i, j, -static_cast<float>(i + 150 * j) / 1000);
    }
    const ZMapSnapshot moment = zmap.snapshot();
    for (const IndexRect& rect :
         {IndexRect{0, 0, 150, 100}, IndexRect{63, 63, 65, 65}, IndexRect{60, 10, 140, 11},
          IndexRect{149, 99, 150, 100}, IndexRect{5, 5, 5, 9}}) {
        std::vector<float> heights(static_cast<std::size_t>(rect.width() * rect.height()));
        moment.read(rect, heights);
        for (int j = rect.j0; j < rect.j1; ++j) {
            for (int i = rect.i0; i < rect.i1; ++i)
                EXPECT_EQ(heights[static_cast<std::size_t>((j - rect.j0) * rect.width() + i - rect.i0)],
                          moment.height(i, j));
        }
    }
}

TEST(ZMapSnapshot, VolumeIsTheIntegralOverCells) {
    std::mt19937 random(7);
    ZMap zmap = freshMap();
    for (int k = 0; k < 3000; ++k)
        write(zmap, static_cast<int>(random() % 150), static_cast<int>(random() % 100),
              -static_cast<float>(random() % 20000) / 1000);
    const ZMapSnapshot moment = zmap.snapshot();
    double cells = 0;
    for (int j = 0; j + 1 < 100; ++j) {
        for (int i = 0; i + 1 < 150; ++i)
            cells += (moment.height(i, j) + moment.height(i + 1, j) + moment.height(i, j + 1) +
                      moment.height(i + 1, j + 1)) /
                         4.0 +
                     20;
    }
    EXPECT_NEAR(moment.volume(), cells, 1e-2);
}

TEST(ZMapSnapshot, KeepsRimsWithItsHeights) {
    ZMapSnapshot moment = freshMap().snapshot();
    EXPECT_TRUE(moment.rims().empty());
    RimMap rims(moment.tileCount());
    rims.edit(3) = std::make_shared<RimTile>(
        RimTile{{{RimEdge{5, 7, true}.index(), 100, 100, RimSides::both, 0, -1, 0, 1}}});
    moment.setRims(rims);
    const ZMapSnapshot copy = moment;
    moment.setRims({});
    EXPECT_TRUE(moment.rims().empty());
    EXPECT_EQ(copy.rims()[0], nullptr);
    EXPECT_EQ(copy.rims()[3], std::as_const(rims)[3]);
    EXPECT_TRUE(ZMap(copy).snapshot().rims().empty()) << "the next cut may move them";
}

TEST(Tile, RefreshesItsMaximum) {
    Tile tile;
    tile.heights.fill(-5);
    for (const std::size_t place : {std::size_t{0}, std::size_t{63}, std::size_t{4095}, std::size_t{777}}) {
        tile.heights[place] = -1;
        tile.maximum = 0;
        tile.refreshMaximum();
        EXPECT_EQ(tile.maximum, -1.0F);
        tile.heights[place] = -5;
    }
}

} // namespace
} // namespace proveout
