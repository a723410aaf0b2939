// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/packed_tile.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <random>

#include "tests/random_seed.h"

namespace proveout {
namespace {

/// Compares bit for bit, so that -0 differs from 0 and NaN equals itself.
void expectKept(const Tile& tile) {
    Tile again;
    unpack(packed(tile), again);
    EXPECT_EQ(std::memcmp(again.heights.data(), tile.heights.data(), sizeof tile.heights), 0);
    EXPECT_EQ(again.blockMaxima, tile.blockMaxima);
    EXPECT_EQ(again.maximum, tile.maximum);
    EXPECT_EQ(again.loweredPoints, tile.loweredPoints);
}

TEST(PackedTile, IsTheTileAgain) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    Tile tile;
    tile.heights.fill(0);
    expectKept(tile);
    for (int i = 0; i < 200; ++i) {
        for (float& height : tile.heights)
            height = std::bit_cast<float>(static_cast<std::uint32_t>(random())); // any bit pattern
        tile.loweredPoints = static_cast<std::uint32_t>(random());
        expectKept(tile);
    }
    for (float& height : tile.heights)
        height = -static_cast<float>(random() % 1000) / 50;
    tile.refreshMaximum();
    expectKept(tile);
}

TEST(PackedTile, TakesLittleOfASmoothSurface) {
    Tile uncut;
    uncut.heights.fill(0);
    EXPECT_LT(packed(uncut).size(), 100U);
    Tile cut; // grooves of a ball-end mill
    for (int j = 0; j < Tile::kSize; ++j) {
        for (int i = 0; i < Tile::kSize; ++i) {
            const double across = std::fmod(i * 0.1 + j * 0.03, 1.0) - 0.5;
            cut.at(i, j) = static_cast<float>(-8 - std::sqrt(25 - across * across) + 0.01 * j);
        }
    }
    cut.refreshMaximum();
    expectKept(cut);
    EXPECT_LT(packed(cut).size(), sizeof(Tile) * 7 / 10);
}

} // namespace
} // namespace proveout
