// SPDX-License-Identifier: GPL-3.0-or-later
// Chips and surface speeds against closed forms, and against the edge of the cutter point by point.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

#include "core/verification/rules/cutting_edge.h"

namespace proveout {
namespace {

Cutter cutterOf(const std::string& spec) {
    return parseCutter(spec).value();
}

TEST(CuttingEdge, ChipsOfACylinderGetThinnerWithItsEngagement) {
    const Cutter mill = cutterOf("flat:d=10");
    EXPECT_DOUBLE_EQ(chipThickness(mill, 0.1, 3, 10), 0.1);
    EXPECT_DOUBLE_EQ(chipThickness(mill, 0.1, 3, 5), 0.1);
    EXPECT_NEAR(chipThickness(mill, 0.1, 3, 2.5), 0.1 * std::sqrt(3) / 2, 1e-12) << "60 degrees of a turn";
    EXPECT_NEAR(chipThickness(mill, 0.1, 3, 5 - 5 / std::sqrt(2)), 0.1 / std::sqrt(2), 1e-12)
        << "45 degrees of a turn";
    EXPECT_DOUBLE_EQ(chipThicknessDown(mill, 0.1, 3), 0.1);
}

TEST(CuttingEdge, ChipsOfABallGetThinnerTowardsItsTip) {
    const Cutter ball = cutterOf("ball:d=10");
    EXPECT_NEAR(edgeAt(ball, 1).radius, 3, 1e-12) << "3, 4 and 5";
    EXPECT_NEAR(chipThickness(ball, 0.1, 1, 6), 0.1 * 3 / 5, 1e-12);
    EXPECT_NEAR(chipThickness(ball, 0.1, 1, 1.5), 0.1 * std::sqrt(3) / 2 * 3 / 5, 1e-12);
    EXPECT_NEAR(chipThickness(ball, 0.1, 9, 10), 0.1, 1e-12) << "above the ball it is a cylinder";
    EXPECT_NEAR(surfaceSpeed(ball, 1, 1000), 6 * std::numbers::pi, 1e-9);
    EXPECT_NEAR(surfaceSpeed(ball, 20, 1000), 10 * std::numbers::pi, 1e-9);
}

TEST(CuttingEdge, ADrillCutsWithItsPoint) {
    const Cutter drill = cutterOf("drill:d=10,angle=118");
    const double half = 59 * std::numbers::pi / 180;
    EXPECT_NEAR(chipThicknessDown(drill, 0.1, 20), 0.1 * std::sin(half), 1e-12);
    EXPECT_NEAR(edgeAt(drill, 1).radius, std::tan(half), 1e-12);
    EXPECT_NEAR(edgeAt(drill, 1).sine, std::cos(half), 1e-12);
}

TEST(CuttingEdge, FollowsTheProfileOfEveryShape) {
    for (const char* spec :
         {"flat:d=8", "ball:d=8", "bull:d=8,r=1.5", "cone:d=8,angle=60,tip=1", "drill:d=8,angle=118",
          "taper:d=6,angle=5,h=10,r=1", "face:d=20,angle=45,h=4,r=0.8", "centre:d=10,pilot=4,pl=5",
          "form:p=0/0:3/0:4/1@3/1:6/3@-2:6/8"}) {
        const Cutter cutter = cutterOf(spec);
        for (double height = 0.05; height < cutter.rimHeight() + 1; height += 0.083) {
            // The largest radius of a profile that is not above the height, by bisection.
            double low = 0;
            double high = cutter.radius() + 1;
            for (int k = 0; k < 60; ++k) {
                const double middle = (low + high) / 2;
                (cutter.height(middle) <= height ? low : high) = middle;
            }
            const CuttingEdge edge = edgeAt(cutter, height);
            ASSERT_NEAR(edge.radius, low, 1e-9) << spec << " at " << height;
            const double step = 1e-6;
            const bool upright =
                low + step > cutter.radius() || cutter.height(low + step) - cutter.height(low - step) > 0.5;
            const double rise =
                upright ? 1 : (cutter.height(low + step) - cutter.height(low - step)) / (2 * step);
            const double sine = upright ? 1 : rise / std::hypot(1, rise);
            ASSERT_NEAR(edge.sine, sine, 1e-3) << spec << " at " << height;
        }
    }
}

} // namespace
} // namespace proveout
