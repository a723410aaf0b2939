// SPDX-License-Identifier: GPL-3.0-or-later
// Every shape of the table with every kind of motion, compared with the brute-force oracle at random points.
// PROVEOUT_MOTIONS sets the number of motions for each; PROVEOUT_SEED sets the seed, which is printed.
#include <array>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>
#include <ostream>
#include <string>

#include "core/cutter/shapes.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

const StockBox kStock{{-3, 5, 2}, 24, 18, 30};
/// The guaranteed accuracy.
constexpr double kAllowed = 1e-3;
constexpr int kPoints = 10;
/// Points close together are computed in single precision, with fitted leads if there are many; points far
/// apart in double precision.
constexpr std::array kSpacings = {0.15, 1.5, 0.05, 0.5};

int motionCount() {
    const char* chosen = std::getenv("PROVEOUT_MOTIONS");
    return chosen == nullptr ? roundsOf(4) : std::stoi(chosen);
}

std::vector<std::string> shapeKeys() {
    std::vector<std::string> keys;
    for (const CutterShape& shape : cutterShapes())
        keys.emplace_back(shape.key);
    return keys;
}

using Case = std::tuple<std::string, MotionRow>;

class ShapesInMotion : public testing::TestWithParam<Case> {};

TEST_P(ShapesInMotion, AgreeWithTheOracle) {
    const auto& [shape, row] = GetParam();
    const std::uint32_t first = randomSeed();
    double largest = 0;
    const int count = motionCount();
    for (int k = 0; k < count; ++k) {
        const std::uint32_t seed = first + static_cast<std::uint32_t>(k);
        Random random(seed);
        const Cutter cutter = randomCutter(random, shape);
        const Motion motion = row.make(random, kStock);
        const double spacing = kSpacings[static_cast<std::size_t>(k) % kSpacings.size()];
        const double error = largestErrorNear(random, cutter, motion, kStock, spacing, row.samples, kPoints);
        EXPECT_LE(error, kAllowed) << fmt::format("seed {} spacing {} {}", seed, spacing,
                                                  reported(cutter, motion));
        largest = std::max(largest, error);
    }
    std::cout << fmt::format("{} {}: {} motions from seed {}, largest error {:.2e} mm\n", shape, row.name,
                             count, first, largest);
}

INSTANTIATE_TEST_SUITE_P(EveryShape, ShapesInMotion,
                         testing::Combine(testing::ValuesIn(shapeKeys()),
                                          testing::ValuesIn(motionRows().begin(), motionRows().end())),
                         [](const testing::TestParamInfo<Case>& one) {
                             return std::get<0>(one.param) + "_" + std::get<1>(one.param).name;
                         });

/// Motions that were once wrong: a hollow that rises from the edge of its flat at the end of an arc, and
/// walls that a piece of an arc moves sideways.
struct OnceWrong {
    const char* shape;
    Plane plane;
    ArcKind kind;
    std::uint32_t seed;
    double spacing;
};

TEST(ShapeMotions, ThatWereOnceWrongAgreeWithTheOracle) {
    constexpr std::array kRows = {
        OnceWrong{"form", Plane::zx, ArcKind::level, 941, 0.05},
        OnceWrong{"form", Plane::zx, ArcKind::level, 6228, 0.15},
        OnceWrong{"form", Plane::yz, ArcKind::level, 5364, 0.15},
        OnceWrong{"form", Plane::xy, ArcKind::helix, 1282, 0.5},
        OnceWrong{"lollipop", Plane::zx, ArcKind::level, 1339, 0.15},
        OnceWrong{"taperball", Plane::yz, ArcKind::level, 5014, 0.05},
    };
    constexpr int kSamples = 1000;
    for (const OnceWrong& row : kRows) {
        Random random(row.seed);
        const Cutter cutter = randomCutter(random, row.shape);
        const Motion motion = randomArc(random, kStock, row.plane, row.kind);
        EXPECT_LE(largestErrorNear(random, cutter, motion, kStock, row.spacing, kSamples, kPoints), kAllowed)
            << reported(cutter, motion);
    }
}

/// Beyond the ends of a slope, where the profile rises at once from the edge of its flat into a hollow, the
/// heights were once those of a place farther along.
TEST(ShapeMotions, OfHollowsAgreeBeyondTheEndsOfASlope) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const StockBox stock{{-3, 5, 2}, 30, 25, 12};
    for (int round = 0; round < roundsOf(60); ++round) {
        const Cutter cutter = randomCutter(random, "form");
        const Motion motion = randomStraight(random, stock, StraightKind::sloped);
        EXPECT_LE(largestError(cutter, motion, stock, 0.15, 1000, 3), kAllowed) << reported(cutter, motion);
    }
}

} // namespace
} // namespace proveout
