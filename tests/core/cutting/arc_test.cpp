// SPDX-License-Identifier: GPL-3.0-or-later
// Compares arcs, helices and spirals in all planes with the brute-force oracle.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/core/cutting/random_motion.h"

namespace proveout {
namespace {

/// A tenth of the guaranteed 1e-3 mm.
constexpr double kAllowed = 1e-4;
constexpr int kSamples = 1000;

using Case = std::tuple<std::string, Plane, ArcKind>;

class ArcMotions : public testing::TestWithParam<Case> {};

TEST_P(ArcMotions, AgreeWithTheOracle) {
    const auto& [shape, plane, kind] = GetParam();
    const StockBox stock{{-3, 5, 2}, 24, 18, 30};
    double largest = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Random random(seed);
        const Cutter cutter = randomCutter(random, shape);
        const Motion motion = randomArc(random, stock, plane, kind);
        SCOPED_TRACE(fmt::format("seed {} {}", seed, reported(cutter, motion)));
        const double error = largestError(cutter, motion, stock, 1.5, kSamples);
        EXPECT_LE(error, kAllowed);
        largest = std::max(largest, error);
    }
    RecordProperty("largestErrorMm", fmt::format("{:.2e}", largest));
}

INSTANTIATE_TEST_SUITE_P(ShapesPlanesAndKinds, ArcMotions,
                         testing::Combine(testing::Values("flat", "ball", "bull", "cone"),
                                          testing::Values(Plane::xy, Plane::zx, Plane::yz),
                                          testing::Values(ArcKind::level, ArcKind::helix, ArcKind::spiral,
                                                          ArcKind::turns)));

} // namespace
} // namespace proveout
