// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/certified/certified_border.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace proveout {
namespace {

std::vector<float> randomHeights(std::mt19937& random, std::size_t count) {
    std::vector<float> heights;
    const double roughness = std::pow(10.0, -static_cast<double>(random() % 4));
    double z = -10;
    for (std::size_t k = 0; k < count; ++k) {
        z += roughness * (static_cast<double>(random()) / 4294967296.0 - 0.5);
        heights.push_back(static_cast<float>(z));
    }
    return heights;
}

bool chordHolds(const std::vector<float>& heights, std::size_t a, std::size_t b, double allowance) {
    for (std::size_t k = a; k <= b; ++k) {
        const double t = static_cast<double>(k - a) / static_cast<double>(b - a);
        const double z = (1 - t) * double{heights[a]} + t * double{heights[b]};
        if (std::abs(z - double{heights[k]}) > allowance)
            return false;
    }
    return true;
}

/// Tries all chords, without cones.
std::size_t fewestVertices(const std::vector<float>& heights, const std::vector<std::uint32_t>& extras,
                           double allowance) {
    std::vector<std::size_t> best(heights.size(), heights.size() + 1);
    best[0] = 1;
    for (std::size_t b = 1; b < heights.size(); ++b) {
        for (std::size_t a = b; a-- > 0;) {
            if (chordHolds(heights, a, b, allowance))
                best[b] = std::min(best[b], best[a] + 1);
            if (std::binary_search(extras.begin(), extras.end(), static_cast<std::uint32_t>(a)))
                break;
        }
    }
    return best.back();
}

TEST(CertifiedBorder, hasTheFewestVerticesThatStayWithinTheAllowance) {
    std::mt19937 random(20);
    for (int round = 0; round < 400; ++round) {
        SCOPED_TRACE(round);
        const std::vector<float> heights = randomHeights(random, 4 + random() % 90);
        const double allowance = 0.3 * std::pow(10.0, -static_cast<double>(random() % 3));
        std::vector<std::uint32_t> extras;
        for (std::uint32_t k = 1; k + 1 < heights.size(); ++k)
            if (round % 2 == 1 && random() % 20 == 0)
                extras.push_back(k);
        const BorderLine line = certifiedBorder(heights, allowance, extras);
        ASSERT_GE(line.kept.size(), 2U);
        EXPECT_EQ(line.kept.front(), 0U);
        EXPECT_EQ(line.kept.back(), heights.size() - 1);
        for (std::size_t k = 0; k + 1 < line.kept.size(); ++k) {
            ASSERT_LT(line.kept[k], line.kept[k + 1]);
            EXPECT_TRUE(chordHolds(heights, line.kept[k], line.kept[k + 1], allowance));
        }
        EXPECT_TRUE(std::includes(line.kept.begin(), line.kept.end(), extras.begin(), extras.end()));
        // The reserve for rounding may reject a chord that is just within the allowance.
        EXPECT_GE(line.kept.size(), fewestVertices(heights, extras, allowance));
        EXPECT_LE(line.kept.size(), fewestVertices(heights, extras, allowance - 1e-9));
    }
}

TEST(CertifiedBorder, keepsTheMiddleOfTwoCells) {
    EXPECT_EQ(certifiedBorder(std::vector<float>(2, -1.0F), 1).kept.size(), 2U);
    EXPECT_EQ(certifiedBorder(std::vector<float>(3, -1.0F), 1).kept.size(), 3U);
    EXPECT_EQ(certifiedBorder(std::vector<float>(4, -1.0F), 1).kept.size(), 2U);
}

} // namespace
} // namespace proveout
