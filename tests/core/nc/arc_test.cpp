// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/geometry/arc.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/core/nc/random_arc.h"

namespace proveout {

using test::uniform;

namespace {

constexpr double kPi = std::numbers::pi;
const ArcTolerances kMm = arcTolerances(ArcRule::linuxcnc, false);

/// An arc that is constructed from its centre, radius and angles, so that all of its values are known.
struct KnownArc {
    Vec2 centre;
    double radius;
    double sweep;
    ArcEnds ends;

    explicit KnownArc(std::mt19937& random)
        : centre(uniform(random, -500, 500), uniform(random, -500, 500)),
          radius(std::exp(uniform(random, -1, 6))),
          sweep(uniform(random, 0.01, 2 * kPi - 0.01) * (random() % 2 == 0 ? 1 : -1)) {
        const double angle = uniform(random, -kPi, kPi);
        ends = {centre + radius * Vec2(std::cos(angle), std::sin(angle)),
                centre + radius * Vec2(std::cos(angle + sweep), std::sin(angle + sweep)), sweep < 0};
    }
};

ArcFault faultOf(const tl::expected<Arc, ArcProblem>& arc) {
    EXPECT_FALSE(arc);
    return arc ? ArcFault::zeroRadius : arc.error().fault;
}

} // namespace

TEST(Arc, AboutItsCentreSweepsAsMade) {
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        const KnownArc known(random);
        const auto arc = arcAbout(known.centre, known.ends, kMm);
        ASSERT_TRUE(arc);
        EXPECT_EQ(arc->centre, known.centre);
        EXPECT_NEAR(arc->sweep, known.sweep, 1e-9);
    }
}

TEST(Arc, OfItsRadiusAgreesWithTheCentre) {
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        const KnownArc known(random);
        // If the chord is nearly the diameter, the centre depends on the last digit of the radius.
        if (std::abs(std::abs(known.sweep) - kPi) < 0.01)
            continue;
        const double radius = std::abs(known.sweep) > kPi ? -known.radius : known.radius;
        const auto arc = arcOfRadius(radius, known.ends, kMm);
        ASSERT_TRUE(arc);
        EXPECT_LT(glm::length(arc->centre - known.centre), 1e-7);
        EXPECT_NEAR(arc->sweep, known.sweep, 1e-9);
    }
}

TEST(Arc, EndsThatCoincideMakeAFullCircle) {
    const Vec2 point(10, 0);
    EXPECT_EQ(arcAbout(Vec2(0), {point, point, false}, kMm)->sweep, 2 * kPi);
    EXPECT_EQ(arcAbout(Vec2(0), {point, point, true}, kMm)->sweep, -2 * kPi);
    EXPECT_NEAR(arcAbout(Vec2(0), {point, point + Vec2(0, 1e-9), false}, kMm)->sweep, 2 * kPi, 1e-9)
        << "what is left of adding up increments";
    EXPECT_NEAR(arcAbout(Vec2(0), {point, point + Vec2(0, 1e-4), false}, kMm)->sweep, 1e-5, 1e-9)
        << "a visible distance is decided by the geometry";
    EXPECT_NEAR(arcAbout(Vec2(0), {point, point - Vec2(0, 1e-4), false}, kMm)->sweep, 2 * kPi - 1e-5, 1e-9);
    EXPECT_EQ(faultOf(arcOfRadius(5, {point, point, false}, kMm)), ArcFault::fullWithRadius);
}

TEST(Arc, OfAFullCircleLeadsToItsEndAsWell) {
    ArcTolerances tolerances = kMm;
    tolerances.samePoint = 0.0005; // half of the least input increment
    const Vec2 point(10, 0);
    for (const double away : {0.0004, -0.0004}) {
        EXPECT_NEAR(arcAbout(Vec2(0), {point, point + Vec2(0, away), false}, tolerances)->sweep,
                    2 * kPi + away / 10, 1e-12);
        EXPECT_NEAR(arcAbout(Vec2(0), {point, point + Vec2(0, away), true}, tolerances)->sweep,
                    -2 * kPi + away / 10, 1e-12);
    }
}

TEST(Arc, ToleratesWhatLinuxCncTolerates) {
    const auto fits = [](double startRadius, double endRadius, bool inch) {
        return arcAbout(Vec2(0), {Vec2(startRadius, 0), Vec2(0, endRadius), false},
                        arcTolerances(ArcRule::linuxcnc, inch))
            .has_value();
    };
    EXPECT_TRUE(fits(10, 10.028, false));
    EXPECT_FALSE(fits(10, 10.029, false)) << "more than 0.0283 mm and more than 0.1 %";
    EXPECT_TRUE(fits(1000, 1000.9, false)) << "less than 0.1 %";
    EXPECT_FALSE(fits(1000, 1001.1, false));
    EXPECT_TRUE(fits(10000, 10002.8, false));
    EXPECT_FALSE(fits(10000, 10002.9, false)) << "more than 2.83 mm, whatever the radius";
    EXPECT_TRUE(fits(10, 10.0715, true)) << "0.00283 inch";
    EXPECT_FALSE(fits(10, 10.0725, true));
    EXPECT_EQ(faultOf(arcAbout(Vec2(0), {Vec2(0.001, 0), Vec2(0, 0.001), false}, kMm)), ArcFault::zeroRadius);
}

TEST(Arc, ForgivesAHairOfRadius) {
    const ArcEnds chord{Vec2(0, 0), Vec2(10, 0), true};
    const auto arc = arcOfRadius(4.999, chord, kMm);
    ASSERT_TRUE(arc);
    EXPECT_EQ(arc->centre, Vec2(5, 0));
    EXPECT_EQ(arc->sweep, -kPi);
    const auto small = arcOfRadius(4.99, chord, kMm);
    ASSERT_FALSE(small);
    EXPECT_EQ(small.error().fault, ArcFault::radiusSmall);
    EXPECT_EQ(small.error().startRadius, 4.99);
    EXPECT_EQ(small.error().endRadius, 5);
    EXPECT_EQ(faultOf(arcOfRadius(0, chord, kMm)), ArcFault::radiusSmall);
}

TEST(Arc, FarCentresKeepTheirDigits) {
    const ArcEnds ends{Vec2(0, 0), Vec2(10, 0), true};
    const auto arc = arcAbout(Vec2(5, -1e9), ends, kMm);
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->sweep, -1e-8, 1e-20);
    EXPECT_NEAR(sagitta(1e9, 1e-8), 10.0 * 10.0 / (8 * 1e9), 1e-20);
    EXPECT_NEAR(sagitta(10, kPi), 10, 1e-12);
}

} // namespace proveout
