// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a stock, against a flood fill of the same points.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/verification/rules/pieces.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

/// Volumes of the pieces in falling order.
std::vector<double> volumesOf(std::vector<Piece> pieces) {
    std::vector<double> volumes;
    for (const Piece& piece : pieces)
        volumes.push_back(piece.volumeMm3);
    std::ranges::sort(volumes, std::greater());
    return volumes;
}

std::vector<double> filled(const ZMapSnapshot& stock) {
    const Grid& grid = stock.grid();
    std::vector<bool> seen(static_cast<std::size_t>(grid.nx * grid.ny));
    const auto at = [&](int i, int j) { return static_cast<std::size_t>(j * grid.nx + i); };
    std::vector<double> volumes;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            double sum = 0;
            std::vector<std::pair<int, int>> open{{i, j}};
            while (!open.empty()) {
                const auto [x, y] = open.back();
                open.pop_back();
                if (x < 0 || y < 0 || x >= grid.nx || y >= grid.ny || seen[at(x, y)] ||
                    !(stock.height(x, y) > stock.floor()))
                    continue;
                seen[at(x, y)] = true;
                sum += static_cast<double>(stock.height(x, y) - stock.floor());
                open.insert(open.end(), {{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}});
            }
            if (sum > 0)
                volumes.push_back(sum * grid.hx * grid.hy);
        }
    std::ranges::sort(volumes, std::greater());
    return volumes;
}

TEST(Pieces, AreThoseOfAFloodFill) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (int round = 0; round < roundsOf(60); ++round) {
        const StockBox box{{-3, 4, 2},
                           1.0 + static_cast<double>(random() % 150),
                           1.0 + static_cast<double>(random() % 150),
                           5};
        ZMap map(box, makeGrid(box, 1).value());
        const auto share = 1 + random() % 9; // of ten points at the floor
        for (int j = 0; j < map.grid().ny; ++j)
            for (int i = 0; i < map.grid().nx; ++i)
                if (random() % 10 < share) {
                    const auto tile =
                        static_cast<std::size_t>(j / Tile::kSize * map.tilesX() + i / Tile::kSize);
                    map.tileForWriting(tile).at(i % Tile::kSize, j % Tile::kSize) = map.floor();
                }
        const std::vector<double> found = volumesOf(piecesOf(map.snapshot()));
        const std::vector<double> expected = filled(map.snapshot());
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k)
            ASSERT_NEAR(found[k], expected[k], 1e-6 * expected[k]);
    }
}

TEST(Pieces, OfAnUncutStockAreOne) {
    const StockBox box{{0, 0, 0}, 20, 10, 4};
    const std::vector<Piece> pieces = piecesOf(ZMap(box, makeGrid(box, 1).value()).snapshot());
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces.front().volumeMm3, 21 * 11 * 4);
    EXPECT_EQ(pieces.front().place, Vec3(0, 0, 0));
}

} // namespace
} // namespace proveout
