// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/decimation/regions/region_decimator.h"
#include "tests/core/decimation/maps.h"

namespace proveout {
namespace {

double largestDistance(const std::vector<float>& heights, const BorderLine& line) {
    double largest = 0;
    for (std::size_t k = 0; k + 1 < line.kept.size(); ++k) {
        const std::uint32_t a = line.kept[k];
        const std::uint32_t b = line.kept[k + 1];
        for (std::uint32_t at = a; at <= b; ++at) {
            const double z = double{heights[a]} + (double{heights[b]} - double{heights[a]}) *
                                                      static_cast<double>(at - a) /
                                                      static_cast<double>(b - a);
            largest = std::max(largest, std::abs(z - double{heights[at]}));
        }
    }
    return largest;
}

std::vector<float> randomBorder(std::mt19937& random, std::size_t points) {
    std::vector<float> heights;
    double z = -20;
    double slope = 0;
    for (std::size_t k = 0; k < points; ++k) {
        slope += static_cast<double>(random() % 100) / 1000 - 0.05;
        z += random() % 20 == 0 ? 3.0 : slope;
        heights.push_back(static_cast<float>(z));
    }
    return heights;
}

TEST(SimplifyBorder, certifiedStaysWithinTheAllowanceVertically) {
    std::size_t dropped = 0;
    for (unsigned seed = 0; seed < 500; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const std::vector<float> heights = randomBorder(random, 2 + random() % 200);
        DecimationParameters parameters = test::leeParameters();
        parameters.allowance = 0.01 * (1.0 + static_cast<double>(random() % 20));
        const BorderLine line = simplifyBorder(heights, 0.1, seed, parameters);
        EXPECT_TRUE(std::is_sorted(line.kept.begin(), line.kept.end()));
        EXPECT_EQ(line.kept.front(), 0U);
        EXPECT_EQ(line.kept.back(), heights.size() - 1);
        EXPECT_LE(largestDistance(heights, line), parameters.allowance);
        dropped += heights.size() - line.kept.size();
        EXPECT_EQ(simplifyBorder(heights, 0.1, seed, parameters).kept, line.kept);
    }
    EXPECT_GT(dropped, 1000U);
}

/// The negative control: the paper's accumulated error alone does not guarantee the border, since it measures
/// perpendicular to the line and not vertically.
TEST(SimplifyBorder, uncertifiedIsSeenToExceedTheAllowance) {
    double worst = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        std::mt19937 random(seed);
        const std::vector<float> heights = randomBorder(random, 200);
        DecimationParameters parameters = test::leeParameters();
        parameters.certify = false;
        worst = std::max(worst, largestDistance(heights, simplifyBorder(heights, 0.1, seed, parameters)));
    }
    EXPECT_GT(worst, 0.05);
}

TEST(SimplifyBorder, aStraightBorderKeepsItsEndsOnly) {
    std::vector<float> heights;
    for (int k = 0; k <= 64; ++k)
        heights.push_back(static_cast<float>(-0.25 * k));
    EXPECT_EQ(simplifyBorder(heights, 1, 3, {}).kept, (std::vector<std::uint32_t>{0, 64}));
}

TEST(SimplifyBorder, keepsEverythingWithoutAllowanceAndOnTwoCells) {
    const std::vector<float> flat(9, -1.0F);
    DecimationParameters exact;
    exact.allowance = 0;
    EXPECT_EQ(simplifyBorder(flat, 1, 1, exact).kept.size(), 9U);
    EXPECT_EQ(simplifyBorder(std::vector<float>(2, 0.0F), 1, 1, {}).kept.size(), 2U);
    EXPECT_EQ(simplifyBorder(std::vector<float>(3, 0.0F), 1, 1, {}).kept.size(), 3U);
    EXPECT_EQ(simplifyBorder(std::vector<float>(4, 0.0F), 1, 1, {}).kept.size(), 2U);
}

TEST(SimplifyBorder, followsTheSeedInRandomOrderOnly) {
    std::mt19937 random(1);
    const std::vector<float> heights = randomBorder(random, 200);
    DecimationParameters parameters = test::leeParameters();
    EXPECT_NE(simplifyBorder(heights, 0.1, 1, parameters).kept,
              simplifyBorder(heights, 0.1, 2, parameters).kept);
    parameters.order = RemovalOrder::sequential;
    EXPECT_EQ(simplifyBorder(heights, 0.1, 1, parameters).kept,
              simplifyBorder(heights, 0.1, 2, parameters).kept);
}

} // namespace
} // namespace proveout
