// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles against the closed formula of each shape.
#include "core/cutter/cutter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

#include "core/cutter/shapes.h"

namespace proveout {
namespace {

struct Expected {
    const char* spec;
    double radius;
    double rim;
    std::function<double(double)> height;
};

const Expected kExpected[] = {
    {"flat:d=10", 5, 0, [](double) { return 0.0; }},
    {"ball:d=11,l=50", 5.5, 5.5, [](double r) { return 5.5 - std::sqrt(5.5 * 5.5 - r * r); }},
    {"bull:d=12,r=2", 6, 2, [](double r) { return r <= 4 ? 0.0 : 2 - std::sqrt(4 - (r - 4) * (r - 4)); }},
    {"bull:d=12,r=0", 6, 0, [](double) { return 0.0; }},
    {"bull:d=12,r=6", 6, 6, [](double r) { return 6 - std::sqrt(36 - r * r); }},
    {"cone:d=8,angle=90", 4, 4, [](double r) { return r; }},
    {"cone:d=8,angle=90,tip=2", 4, 3, [](double r) { return std::max(0.0, r - 1); }},
    {"cone:d=6,angle=60", 3, 3 * std::sqrt(3.0), [](double r) { return r * std::sqrt(3.0); }},
    {"drill:d=10,angle=90", 5, 5, [](double r) { return r; }},
    {"drill:d=6,angle=120,l=40", 3, std::sqrt(3.0), [](double r) { return r / std::sqrt(3.0); }},
};

TEST(Cutter, HeightsFollowTheFormulaOfTheShape) {
    for (const Expected& expected : kExpected) {
        SCOPED_TRACE(expected.spec);
        const Cutter cutter = parseCutter(expected.spec).value();
        EXPECT_DOUBLE_EQ(cutter.radius(), expected.radius);
        EXPECT_NEAR(cutter.rimHeight(), expected.rim, 1e-12);
        for (int k = 0; k <= 100; ++k) {
            const double r = expected.radius * k / 100;
            EXPECT_NEAR(cutter.height(r), expected.height(r), 1e-12) << "at radius " << r;
        }
    }
}

TEST(Cutter, TheRimBelongsToTheCutterAndNothingBeyond) {
    for (const Expected& expected : kExpected) {
        SCOPED_TRACE(expected.spec);
        const Cutter cutter = parseCutter(expected.spec).value();
        EXPECT_NEAR(cutter.height(cutter.radius()), cutter.rimHeight(), 1e-12);
        EXPECT_EQ(cutter.height(std::nextafter(cutter.radius(), 1e9)),
                  std::numeric_limits<double>::infinity());
    }
}

TEST(Cutter, PiecesJoinWithoutGapsAndRise) {
    for (const Expected& expected : kExpected) {
        SCOPED_TRACE(expected.spec);
        const Cutter cutter = parseCutter(expected.spec).value();
        double r = 0;
        double z = 0;
        for (const ProfilePiece& piece : cutter.pieces()) {
            EXPECT_DOUBLE_EQ(piece.r0, r);
            EXPECT_NEAR(piece.z0, z, 1e-12);
            EXPECT_GT(piece.r1, piece.r0);
            EXPECT_GE(piece.z1, piece.z0);
            r = piece.r1;
            z = piece.z1;
        }
    }
}

} // namespace
} // namespace proveout
