// SPDX-License-Identifier: GPL-3.0-or-later
// Removed volumes against closed formulas. A sum over grid points meets an integral to the order of the
// spacing at vertical walls, and of its square elsewhere; the allowances below are those.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "core/cutting/cutting.h"
#include "tests/core/cutting/random_motion.h"

namespace proveout {
namespace {

constexpr double kPi = std::numbers::pi;
const StockBox kStock{{0, 0, 0}, 100, 80, 30};
constexpr double kSpacing = 0.1;

double removed(const char* spec, const Motion& motion) {
    ZMap zmap(kStock, makeGrid(kStock, kSpacing).value());
    return cut(zmap, cutterOf(spec), motion).removedMm3;
}

TEST(Volume, OfASlot) {
    const double exact = 3 * (60 * 10 + kPi * 25);
    EXPECT_NEAR(removed("flat:d=10", straightMotion({20, 40, -3}, {80, 40, -3})), exact, 0.02 * exact);
}

TEST(Volume, OfASlotFromEdgeToEdgeIsExactToTheWalls) {
    // 101 rows of points are cut: those on the rim belong to the cutter.
    const double exact = 3 * 100 * 10.1;
    EXPECT_NEAR(removed("flat:d=10", straightMotion({-20, 40, -3}, {120, 40, -3})), exact, 1e-3);
}

TEST(Volume, AlongTheEdgeOfTheStockCountsBorderPointsHalf) {
    const double exact = 3 * 100 * 5.05;
    EXPECT_NEAR(removed("flat:d=10", straightMotion({-20, 0, -3}, {120, 0, -3})), exact, 1e-3);
    EXPECT_NEAR(removed("flat:d=10", straightMotion({0, -20, -3}, {0, 120, -3})), 3 * 80 * 5.05, 1e-3);
}

TEST(Volume, OfABallGroove) {
    // A half cylinder that runs out over both edges.
    const double exact = 100 * kPi * 25 / 2;
    EXPECT_NEAR(removed("ball:d=10", straightMotion({-20, 40, -5}, {120, 40, -5})), exact, 2e-3 * exact);
}

TEST(Volume, OfASlopingBallGroove) {
    // Perpendicular to the path the groove is a half circle: over ground, one wider by the slope.
    const double slope = 0.05;
    const double width = 10.0;
    // Depth of the tip below the top, far from 0 all along: area of the section at depth p below the centre.
    const Motion motion = straightMotion({-20, 40, -5 + 20 * slope - 6}, {120, 40, -5 - 120 * slope - 6});
    const double stretch = std::sqrt(1 + slope * slope);
    double exact = 0;
    for (int k = 0; k < 1000; ++k) {
        const double x = 100 * (k + 0.5) / 1000;
        const double centre = 6 + slope * x;
        exact += 0.1 * (width * centre + kPi * 25 * stretch / 2);
    }
    EXPECT_NEAR(removed("ball:d=10", motion), exact, 0.015 * exact);
}

TEST(Volume, OfAConePlunge) {
    const double exact = kPi * 8 * 8 * 8 / 3;
    EXPECT_NEAR(removed("cone:d=20,angle=90", straightMotion({50, 40, 5}, {50, 40, -8})), exact,
                1e-3 * exact);
}

TEST(Volume, OfABullNosePlunge) {
    // A disc of radius 3 and a quarter torus tube round it, to the depth of the corner radius.
    const double exact = kPi * 9 * 2 + kPi * kPi * 3 * 4 / 2 + 2.0 / 3 * kPi * 8;
    EXPECT_NEAR(removed("bull:d=10,r=2", straightMotion({50, 40, 5}, {50, 40, -2})), exact, 2e-3 * exact);
}

TEST(Volume, OfARingGroove) {
    const Motion ring = arcMotion(Plane::xy, {50, 40, -4}, 20, 0.3, 2 * kPi, 0, 20);
    const double exact = 2 * kPi * 20 * kPi * 16 / 2; // Pappus
    EXPECT_NEAR(removed("ball:d=8", ring), exact, 2e-3 * exact);
}

TEST(Volume, OfAPocketIsThatOfItsOutline) {
    ZMap zmap(kStock, makeGrid(kStock, kSpacing).value());
    const Cutter cutter = cutterOf("flat:d=10");
    double sum = 0;
    for (int pass = 0; pass <= 10; ++pass) {
        const double y = 20.0 + 4 * pass;
        sum += cut(zmap, cutter, straightMotion({20, y, -2}, {80, y, -2})).removedMm3;
    }
    const ZMapSnapshot moment = zmap.snapshot();
    EXPECT_NEAR(sum, 100.0 * 80 * 30 - moment.volume(), 1e-6);
    // A rectangle with a row of rounded ends on two sides; between passes 4 mm apart stand small tips.
    const double tips = 2 * 10 * (4 * 5 - 2 * std::sqrt(21.0) - 25 * std::asin(0.4));
    const double exact = 2 * (60 * 50 + 40 * 10 + kPi * 25 - tips);
    EXPECT_NEAR(sum, exact, 0.01 * exact);
}

} // namespace
} // namespace proveout
