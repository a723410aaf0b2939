// SPDX-License-Identifier: GPL-3.0-or-later
// Compares arcs, helices and spirals in all planes with the brute-force oracle.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

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

// A row of points only micrometres beyond the edge of a flat, where a hollow begins as a wall: in an upright
// arc such points are lowest between two ends of its pieces.
TEST(UprightArcs, CutTheSteepBeginningOfAHollowBesideTheirPlane) {
    constexpr double kAllowedOnWalls = 1e-3;
    const Cutter cutter = parseCutter("form:p=0/0:3/0:4/1@3/1:6/3@6/1:6/8").value();
    const StockBox row{{0, 9, 0}, 24, 0.2, 30};
    for (const double beyond : {2e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3}) {
        SCOPED_TRACE(fmt::format("{} mm beyond the edge", beyond));
        Motion motion;
        motion.kind = MotionKind::arc;
        motion.plane = Plane::zx;
        motion.startKnown = motion.endKnown = kAllAxes;
        motion.centre = {12.1, 9 - 4 - beyond, 14};
        motion.start = motion.centre + Vec3(-12, 0, -16);
        motion.end = motion.centre + Vec3(12, 0, -16);
        motion.sweep = -2 * std::atan2(12, 16);
        EXPECT_LE(largestError(cutter, motion, row, 0.1, 4000), kAllowedOnWalls);
    }
}

INSTANTIATE_TEST_SUITE_P(ShapesPlanesAndKinds, ArcMotions,
                         testing::Combine(testing::Values("flat", "ball", "bull", "cone"),
                                          testing::Values(Plane::xy, Plane::zx, Plane::yz),
                                          testing::Values(ArcKind::level, ArcKind::helix, ArcKind::spiral,
                                                          ArcKind::turns)));

} // namespace
} // namespace proveout
