// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/region_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

namespace proveout {
namespace {

struct Size {
    int nx, ny, cells;
};

class RegionGridOf : public testing::TestWithParam<Size> {};

INSTANTIATE_TEST_SUITE_P(Sizes, RegionGridOf,
                         testing::Values(Size{2, 2, 1}, Size{2, 2, 8}, Size{141, 141, 8}, Size{141, 101, 8},
                                         Size{10, 7, 3}, Size{18, 17, 8}, Size{9, 33, 16}, Size{65, 64, 64},
                                         Size{66, 130, 64}, Size{5, 6, 2}),
                         [](const auto& param) {
                             return std::to_string(param.param.nx) + "x" + std::to_string(param.param.ny) +
                                    "by" + std::to_string(param.param.cells);
                         });

TEST_P(RegionGridOf, regionsHoldEachCellOnce) {
    const auto [nx, ny, cells] = GetParam();
    const RegionGrid grid(nx, ny, cells);
    std::map<std::pair<int, int>, int> covered;
    for (std::size_t region = 0; region < grid.regionCount(); ++region) {
        const IndexRect rect = grid.points(region);
        EXPECT_GE(rect.width(), 2);
        EXPECT_LE(rect.width(), cells + 1);
        EXPECT_GE(rect.height(), 2);
        EXPECT_LE(rect.height(), cells + 1);
        for (int j = rect.j0; j + 1 < rect.j1; ++j)
            for (int i = rect.i0; i + 1 < rect.i1; ++i)
                ++covered[{i, j}];
    }
    EXPECT_EQ(covered.size(), static_cast<std::size_t>((nx - 1) * (ny - 1)));
    for (const auto& [cell, times] : covered)
        EXPECT_EQ(times, 1) << cell.first << ", " << cell.second;
}

TEST_P(RegionGridOf, neighboursShareTheirBorderAndItsPoints) {
    const auto [nx, ny, cells] = GetParam();
    const RegionGrid grid(nx, ny, cells);
    std::map<std::size_t, std::vector<std::pair<std::size_t, IndexRect>>> found;
    for (std::size_t region = 0; region < grid.regionCount(); ++region) {
        const IndexRect r = grid.points(region);
        const std::map<Side, IndexRect> expected{{Side::south, {r.i0, r.j0, r.i1, r.j0 + 1}},
                                                 {Side::north, {r.i0, r.j1 - 1, r.i1, r.j1}},
                                                 {Side::west, {r.i0, r.j0, r.i0 + 1, r.j1}},
                                                 {Side::east, {r.i1 - 1, r.j0, r.i1, r.j1}}};
        for (const Side side : kSides) {
            const std::size_t border = grid.border(region, side);
            EXPECT_EQ(grid.borders(region)[static_cast<std::size_t>(side)], border);
            EXPECT_EQ(grid.borderPoints(border), expected.at(side));
            found[border].emplace_back(region, expected.at(side));
        }
    }
    EXPECT_EQ(found.size(), grid.borderCount());
    EXPECT_EQ(found.rbegin()->first + 1, grid.borderCount());
    for (const auto& [border, regions] : found) {
        const auto sharers = grid.sharers(border);
        ASSERT_LE(regions.size(), 2U);
        EXPECT_EQ(sharers[0], regions[0].first);
        EXPECT_EQ(sharers[1], regions.size() == 2 ? regions[1].first : RegionGrid::kNoRegion);
        EXPECT_EQ(regions.front().second, regions.back().second);
    }
}

TEST_P(RegionGridOf, regionsTouchingAreThoseThatHoldAPoint) {
    const auto [nx, ny, cells] = GetParam();
    const RegionGrid grid(nx, ny, cells);
    constexpr unsigned kSeed = 5;
    SCOPED_TRACE(kSeed);
    std::mt19937 random(kSeed);
    const auto pick = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
    for (int trial = 0; trial < 300; ++trial) {
        const int i = pick(nx + 4) - 2;
        const int j = pick(ny + 4) - 2;
        const IndexRect rect{i, j, i + pick(cells + 3), j + pick(cells + 3)};
        const IndexRect regions = grid.regionsTouching(rect);
        for (int ry = 0; ry < grid.regionsY(); ++ry) {
            for (int rx = 0; rx < grid.regionsX(); ++rx) {
                const bool holds = !intersection(grid.points(grid.regionAt(rx, ry)), rect).empty();
                const bool listed =
                    rx >= regions.i0 && rx < regions.i1 && ry >= regions.j0 && ry < regions.j1;
                EXPECT_EQ(listed, holds) << rx << ", " << ry;
            }
        }
    }
}

TEST(SnapToKept, goesToTheNearerKeptNeighbourAndBesideACornerToTheCorner) {
    EXPECT_EQ(snapToKept({{0, 8}}, 8), (std::vector<std::uint32_t>{0, 0, 0, 0, 0, 8, 8, 8, 8}));
    EXPECT_EQ(snapToKept({{0, 3, 6, 8}}, 8), (std::vector<std::uint32_t>{0, 0, 3, 3, 3, 6, 6, 8, 8}));
    EXPECT_EQ(snapToKept({{0, 1, 2, 3}}, 3), (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(snapToKept({{0, 1}}, 1), (std::vector<std::uint32_t>{0, 1}));
}

TEST(SnapToKept, risesAndKeepsWhatIsKept) {
    for (std::uint32_t n = 1; n <= 10; ++n) {
        for (std::uint32_t bits = 0; bits < 1U << (n - 1); ++bits) {
            BorderLine line{{0}};
            for (std::uint32_t k = 1; k < n; ++k)
                if ((bits >> (k - 1) & 1U) != 0)
                    line.kept.push_back(k);
            line.kept.push_back(n);
            const std::vector<std::uint32_t> target = snapToKept(line, n);
            ASSERT_EQ(target.size(), n + 1);
            EXPECT_TRUE(std::is_sorted(target.begin(), target.end()));
            for (std::uint32_t k = 0; k <= n; ++k) {
                const bool kept = std::binary_search(line.kept.begin(), line.kept.end(), k);
                EXPECT_EQ(target[k] == k, kept);
                EXPECT_TRUE(std::binary_search(line.kept.begin(), line.kept.end(), target[k]));
            }
        }
    }
}

} // namespace
} // namespace proveout
