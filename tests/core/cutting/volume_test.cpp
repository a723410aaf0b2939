// SPDX-License-Identifier: GPL-3.0-or-later
// Compares removed volumes with closed formulas. The error of a sum over grid points is of the order of the
// spacing at vertical walls, and of its square elsewhere; the tolerances below follow from that. Walls along
// rows of points are a special case, because points on the rim belong to the cutter.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

#include "core/cutting/cut/cutting.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

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
    // 101 rows of points are cut, because points on the rim belong to the cutter.
    const double exact = 3 * 100 * 10.1;
    EXPECT_NEAR(removed("flat:d=10", straightMotion({-20, 40, -3}, {120, 40, -3})), exact, 1e-3);
}

TEST(Volume, AlongTheEdgeOfTheStockCountsBorderPointsHalf) {
    const double exact = 3 * 100 * 5.05;
    EXPECT_NEAR(removed("flat:d=10", straightMotion({-20, 0, -3}, {120, 0, -3})), exact, 1e-3);
    EXPECT_NEAR(removed("flat:d=10", straightMotion({0, -20, -3}, {0, 120, -3})), 3 * 80 * 5.05, 1e-3);
}

TEST(Volume, OfABallGroove) {
    // A half cylinder that extends beyond both edges.
    const double exact = 100 * kPi * 25 / 2;
    EXPECT_NEAR(removed("ball:d=10", straightMotion({-20, 40, -5}, {120, 40, -5})), exact, 2e-3 * exact);
}

TEST(Volume, OfASlopingBallGroove) {
    // The groove is a half circle perpendicular to the path: a vertical section of it is higher by the slope.
    const double slope = 0.05;
    const double width = 10.0;
    // The tip stays far below the top along the whole path; `centre` is the depth of the centre of the ball.
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
    // A disc of radius 3 and a quarter torus around it, down to the depth of the corner radius.
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
    // A rectangle with a row of rounded ends on two sides; passes 4 mm apart leave small tips between them.
    const double tips = 2 * 10 * (4 * 5 - 2 * std::sqrt(21.0) - 25 * std::asin(0.4));
    const double exact = 2 * (60 * 50 + 40 * 10 + kPi * 25 - tips);
    EXPECT_NEAR(sum, exact, 0.01 * exact);
}

// Anywhere in the stock and in any direction: within a fifth of a per cent at a tenth of a millimetre.
constexpr double kAllowed = 2e-3;
constexpr int kPlaces = 40;

/// Calls `check` with positions that are independent of the grid, and prints the seed of a failure.
template<class Check>
void atRandomPlaces(const Check& check) {
    const std::uint32_t seed = randomSeed();
    Random random(seed);
    for (int k = 0; k < kPlaces; ++k) {
        const Vec2 place(uniform(random, 40, 60), uniform(random, 35, 45));
        const double angle = uniform(random, -kPi, kPi);
        SCOPED_TRACE("seed " + std::to_string(seed) + " place " + std::to_string(place.x) + "," +
                     std::to_string(place.y) + " angle " + std::to_string(angle));
        check(place, angle);
    }
}

TEST(VolumeAnywhere, OfASlot) {
    // Two long straight walls. In a direction in which points form rows, e.g. 45 degrees, a wall may be off
    // by half the distance of the rows, so the guarantee applies to the mean over all positions.
    double sum = 0;
    const double exact = 3 * (40 * 10 + kPi * 25);
    atRandomPlaces([&](const Vec2& place, double angle) {
        const Vec2 half = 20.0 * Vec2(std::cos(angle), std::sin(angle));
        const double volume =
            removed("flat:d=10", straightMotion(Vec3(place - half, -3), Vec3(place + half, -3)));
        EXPECT_NEAR(volume, exact, kSpacing / 10 * exact);
        sum += volume;
    });
    EXPECT_NEAR(sum / kPlaces, exact, kAllowed * exact);
}

TEST(VolumeAnywhere, OfAPocket) {
    atRandomPlaces([](const Vec2& place, double angle) {
        const Vec2 along(std::cos(angle), std::sin(angle));
        const Vec2 beside(-along.y, along.x);
        ZMap zmap(kStock, makeGrid(kStock, kSpacing).value());
        const Cutter cutter = cutterOf("flat:d=10");
        double sum = 0;
        for (int pass = -4; pass <= 4; ++pass) {
            const Vec2 middle = place + 4.0 * pass * beside;
            sum += cut(zmap, cutter,
                       straightMotion(Vec3(middle - 15.0 * along, -2), Vec3(middle + 15.0 * along, -2)))
                       .removedMm3;
        }
        const double tips = 2 * 8 * (4 * 5 - 2 * std::sqrt(21.0) - 25 * std::asin(0.4));
        const double exact = 2 * (30 * 42 + 32 * 10 + kPi * 25 - tips);
        EXPECT_NEAR(sum, exact, kAllowed * exact);
    });
}

TEST(VolumeAnywhere, OfADrilledCone) {
    atRandomPlaces([](const Vec2& place, double) {
        // The point of the drill alone: its angle is 118 degrees.
        const double steep = 1 / std::tan(118.0 / 2 * kPi / 180);
        const double depth = 4;
        const double exact = kPi * depth * depth / (steep * steep) * depth / 3;
        EXPECT_NEAR(removed("drill:d=20,angle=118", straightMotion(Vec3(place, 5), Vec3(place, -depth))),
                    exact, kAllowed * exact);
    });
}

TEST(VolumeAnywhere, OfABallGroove) {
    atRandomPlaces([](const Vec2& place, double angle) {
        const Vec2 half = 15.0 * Vec2(std::cos(angle), std::sin(angle));
        const double exact = 30 * kPi * 25 / 2 + 2.0 / 3 * kPi * 125;
        EXPECT_NEAR(removed("ball:d=10", straightMotion(Vec3(place - half, -5), Vec3(place + half, -5))),
                    exact, kAllowed * exact);
    });
}

/// The volume that a flat cutter of `radius` removes on its way down a helix with the given `pitch` per turn:
/// over each point it is lowest where it leaves it for the last time, half a chord ahead. Integrated in polar
/// coordinates.
double helixVolume(double circle, double radius, double pitch, double turns) {
    constexpr int kSteps = 400;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double r = circle + radius * (2 * (i + 0.5) / kSteps - 1);
        const double cosine = (r * r + circle * circle - radius * radius) / (2 * r * circle);
        const double ahead = std::acos(std::min(1.0, cosine));
        for (int k = 0; k < kSteps; ++k) {
            // The last angle of the path at which the cutter is over the point.
            const double at = 2 * kPi * (k + 0.5) / kSteps;
            const double end = 2 * kPi * turns;
            double last = at - ahead;
            for (double turn = 0; turn <= turns; ++turn) {
                const double from = at + 2 * kPi * turn - ahead;
                const double to = at + 2 * kPi * turn + ahead;
                if (from <= end)
                    last = std::min(to, end);
            }
            sum += pitch * std::max(0.0, last) / (2 * kPi) * r * 2 * radius / kSteps * 2 * kPi / kSteps;
        }
    }
    return sum;
}

TEST(VolumeAnywhere, OfAHelix) {
    atRandomPlaces([](const Vec2& place, double angle) {
        // A flat cutter descends by three turns, and makes another turn at full depth; its ring leaves a
        // core.
        ZMap zmap(kStock, makeGrid(kStock, kSpacing).value());
        const Cutter cutter = cutterOf("flat:d=10");
        const Motion down = arcMotion(Plane::xy, Vec3(place, 0), 12, angle, 6 * kPi, -6, 12);
        const Motion round = arcMotion(Plane::xy, Vec3(place, -6), 12, angle, 2 * kPi, 0, 12);
        const double helix = cut(zmap, cutter, down).removedMm3;
        const double rest = cut(zmap, cutter, round).removedMm3;
        const double ring = kPi * (17 * 17 - 7 * 7);
        EXPECT_NEAR(helix + rest, 6 * ring, kAllowed * 6 * ring);
        EXPECT_NEAR(helix, helixVolume(12, 5, 2, 3), kAllowed * 6 * ring);
    });
}

} // namespace
} // namespace proveout
