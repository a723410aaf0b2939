// SPDX-License-Identifier: GPL-3.0-or-later
// Compares straight motions of all shapes and slopes with the brute-force oracle.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <utility>

#include "tests/core/cutting/random_motion.h"

namespace proveout {
namespace {

/// The guarantee is 1e-3 mm; single precision achieves this smaller error, so the test requires it.
constexpr double kAllowed = 1e-4;
constexpr int kSamples = 300;

using Case = std::tuple<std::string, StraightKind>;

class StraightMotions : public testing::TestWithParam<Case> {};

TEST_P(StraightMotions, AgreeWithTheOracle) {
    const auto& [shape, kind] = GetParam();
    const StockBox stock{{-3, 5, 2}, 24, 18, 30};
    double largest = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        const Cutter cutter = randomCutter(random, shape);
        const Motion motion = randomStraight(random, stock, kind);
        SCOPED_TRACE(fmt::format("seed {} {}", seed, reported(cutter, motion)));
        // Points close together use single precision, points far apart double precision.
        for (const auto& [spacing, stride] : {std::pair{0.15, 10}, {1.5, 1}}) {
            const double error = largestError(cutter, motion, stock, spacing, kSamples, stride);
            EXPECT_LE(error, kAllowed) << "spacing " << spacing;
            largest = std::max(largest, error);
        }
    }
    RecordProperty("largestErrorMm", fmt::format("{:.2e}", largest));
}

INSTANTIATE_TEST_SUITE_P(ShapesAndSlopes, StraightMotions,
                         testing::Combine(testing::Values("flat", "ball", "bull", "cone"),
                                          testing::Values(StraightKind::level, StraightKind::sloped,
                                                          StraightKind::steep, StraightKind::plunge,
                                                          StraightKind::still)));

} // namespace
} // namespace proveout
