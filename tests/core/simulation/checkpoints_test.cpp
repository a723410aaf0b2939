// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/checkpoints.h"

#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "tests/core/simulation/moments.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr int kTiles = 16; // 4 × 4

ZMap wideMap() {
    const StockBox stock{Vec3(0), 255, 255, 10};
    return {stock, makeGrid(stock, 1).value()};
}

/// Changes one tile and returns the checkpoint.
Checkpoint next(ZMap& zmap, std::size_t block) {
    zmap.tileForWriting(block % kTiles).at(0, 0) = -static_cast<float>(block);
    return {block, zmap.snapshot(), 0, static_cast<double>(block)};
}

TEST(Checkpoints, CountEachTileOnce) {
    ZMap zmap = wideMap();
    Checkpoints checkpoints;
    checkpoints.restart({0, zmap.snapshot(), 0, 0});
    const std::size_t uncut = checkpoints.bytes();
    const std::size_t pointers = kTiles * sizeof(std::shared_ptr<const Tile>);
    EXPECT_EQ(uncut, sizeof(Tile) + pointers) << "uncut tiles are one";
    for (std::size_t block = 1; block <= 10; ++block)
        checkpoints.add(next(zmap, block));
    EXPECT_EQ(checkpoints.bytes(), uncut + 10 * (sizeof(Tile) + pointers));
}

TEST(Checkpoints, StayWithinTheirBudgetAndFindTheNearest) {
    ZMap zmap = wideMap();
    Checkpoints checkpoints;
    checkpoints.setBudget(200 * sizeof(Tile));
    checkpoints.restart({0, zmap.snapshot(), 0, 0});
    for (std::size_t block = 1; block <= 500; ++block) {
        checkpoints.add(next(zmap, block));
        ASSERT_LE(checkpoints.bytes(), 200 * sizeof(Tile));
        ASSERT_EQ(checkpoints.before(0).block, 0U);
    }
    EXPECT_GT(checkpoints.size(), 10U);
    std::size_t widest = 0;
    for (std::size_t block = 0; block <= 500; ++block) {
        ASSERT_LE(checkpoints.before(block).block, block);
        widest = std::max(widest, block - checkpoints.before(block).block);
    }
    EXPECT_LT(widest, 3 * 500 / checkpoints.size()); // thinned evenly and not at one end
}

TEST(Checkpoints, PackBeforeTheyAreThinned) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    ZMap zmap = wideMap();
    Checkpoints checkpoints;
    checkpoints.setBudget(60 * sizeof(Tile));
    checkpoints.restart({0, zmap.snapshot(), 0, 0});
    std::vector<ZMapSnapshot> moments{zmap.snapshot()};
    for (std::size_t block = 1; block <= 400; ++block) {
        // Each block changes one tile.
        const Checkpoint checkpoint = next(zmap, block);
        moments.push_back(checkpoint.zmap);
        checkpoints.add(checkpoint);
        ASSERT_LE(checkpoints.bytes(), 60 * sizeof(Tile));
        const std::size_t asked = random() % (block + 1);
        const Checkpoint found = checkpoints.before(asked);
        ASSERT_EQ(found.block, checkpoints.blockBefore(asked));
        ASSERT_LE(found.block, asked);
        ASSERT_TRUE(sameZMap(found.zmap, moments[found.block])) << "block " << found.block;
        // As long as a tile is referenced, the same tile is returned, so that viewers upload nothing.
        const Checkpoint again = checkpoints.before(asked);
        for (std::size_t tile = 0; tile < found.zmap.tileCount(); ++tile)
            ASSERT_EQ(found.zmap.tile(tile), again.zmap.tile(tile));
    }
    EXPECT_GT(checkpoints.packedTiles(), 0U);
    EXPECT_GT(checkpoints.size(), 150U) << "plain tiles would leave room for 40 of them";
}

TEST(Checkpoints, AreForgottenBehindAnEdit) {
    ZMap zmap = wideMap();
    Checkpoints checkpoints;
    checkpoints.restart({0, zmap.snapshot(), 0, 0});
    const std::size_t uncut = checkpoints.bytes();
    for (std::size_t block = 10; block <= 50; block += 10)
        checkpoints.add(next(zmap, block));
    checkpoints.truncate(25);
    EXPECT_EQ(checkpoints.before(1000).block, 20U);
    checkpoints.truncate(0);
    EXPECT_EQ(checkpoints.size(), 1U);
    EXPECT_EQ(checkpoints.bytes(), uncut);
}

TEST(Checkpoints, AreNotWantedWithoutABudget) {
    Checkpoints checkpoints;
    EXPECT_TRUE(checkpoints.wanted());
    checkpoints.setBudget(0);
    EXPECT_FALSE(checkpoints.wanted());
}

} // namespace
} // namespace proveout
