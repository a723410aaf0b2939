// SPDX-License-Identifier: GPL-3.0-or-later
// Compares profiles with the closed formula of each shape.
#include "core/cutter/cutter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <utility>

#include "core/cutter/shapes.h"
#include "core/cutter/solvable_pieces.h"
#include "tests/core/cutter/default_spec.h"

namespace proveout {
namespace {

struct Expected {
    const char* spec;
    double radius;
    double rim;
    std::function<double(double)> height;
};

/// The height of a side inclined by `lean` degrees from (3, 0), whose corner has radius `corner`.
double roundedSide(double r, double lean, double corner) {
    const double radians = lean * std::numbers::pi / 180;
    const double ring = 3 - corner * std::tan(std::numbers::pi / 4 - radians / 2);
    if (r <= ring)
        return 0;
    if (r <= ring + corner * std::cos(radians))
        return corner - std::sqrt(corner * corner - (r - ring) * (r - ring));
    return (r - 3) / std::tan(radians);
}

double sideBehind(double r, double from, double slope) {
    return std::max(0.0, r - from) * slope;
}

double ballOf(double r, double radius) {
    return radius - std::sqrt(radius * radius - r * r);
}

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
    {"taper:d=6,angle=45,h=2", 5, 2, [](double r) { return sideBehind(r, 3, 1); }},
    {"taper:d=6,angle=30,h=3,r=1", 3 + std::sqrt(3.0), 3, [](double r) { return roundedSide(r, 30, 1); }},
    {"taperball:d=4,angle=30,h=3", std::sqrt(3.0) + 2 / std::sqrt(3.0), 3,
     [](double r) { return r <= std::sqrt(3.0) ? ballOf(r, 2) : 1 + (r - std::sqrt(3.0)) * std::sqrt(3.0); }},
    {"chamfer:d=8,angle=90,tip=2", 4, 3, [](double r) { return sideBehind(r, 1, 1); }},
    {"face:d=6,angle=90,h=5,r=1", 3, 1, [](double r) { return r <= 2 ? 0 : ballOf(r - 2, 1); }},
    {"face:d=6,angle=60,h=2,r=0.5", 3 + 2 / std::sqrt(3.0), 2,
     [](double r) { return roundedSide(r, 30, 0.5); }},
    {"spot:d=10,angle=90", 5, 5, [](double r) { return r; }},
    {"centre:d=8,pilot=2,pl=4,angle=90,point=90", 4, 7, [](double r) { return r <= 1 ? r : 4 + (r - 1); }},
    {"reamer:d=8,lead=1,angle=45", 4, 1, [](double r) { return sideBehind(r, 3, 1); }},
    {"reamer:d=8,lead=0", 4, 0, [](double) { return 0.0; }},
    {"tap:d=8,tip=6,lead=3", 4, 3, [](double r) { return sideBehind(r, 3, 3); }},
    {"threadmill:d=8", 4, 0, [](double) { return 0.0; }},
    {"threadmill:d=8,tip=4,lead=2", 4, 2, [](double r) { return sideBehind(r, 2, 1); }},
    {"lollipop:d=10,neck=6", 5, 5, [](double r) { return ballOf(r, 5); }},
    {"tslot:d=20,w=4,neck=8", 10, 0, [](double) { return 0.0; }},
    {"tslot:d=20,w=4,neck=8,r=1", 10, 1, [](double r) { return r <= 9 ? 0 : ballOf(r - 9, 1); }},
    {"dovetail:d=20,angle=60,h=5", 10, 0, [](double) { return 0.0; }},
    {"dovetail:d=20,angle=60,h=5,r=0.5", 10, 0.5,
     [](double r) { return r <= 9.5 ? 0 : ballOf(r - 9.5, 0.5); }},
    {"form:p=0/0:2/0:3/2:3/3:5/3", 5, 3, [](double r) { return r <= 2   ? 0.0
                                                               : r <= 3 ? 2 * (r - 2)
                                                                        : 3.0; }},
    {"form:p=0/0:1/1@0/1:1/2:3/4@3/2", 3, 4,
     [](double r) { return r <= 1 ? ballOf(r, 1) : 2 + std::sqrt(4 - (3 - r) * (3 - r)); }},
    {"form:p=0/0:1/1@1:1/2:3/4@-2", 3, 4,
     [](double r) { return r <= 1 ? ballOf(r, 1) : 2 + std::sqrt(4 - (3 - r) * (3 - r)); }},
};

TEST(Cutter, HeightsFollowTheFormulaOfTheShape) {
    for (const Expected& expected : kExpected) {
        SCOPED_TRACE(expected.spec);
        const Cutter cutter = parseCutter(expected.spec).value();
        EXPECT_DOUBLE_EQ(cutter.radius(), expected.radius);
        EXPECT_NEAR(cutter.rimHeight(), expected.rim, 1e-12);
        for (int k = 0; k <= 100; ++k) {
            const double r = expected.radius * k / 100;
            // Next to a wall and where an arc ends vertically, rounding of the radius decides the result.
            EXPECT_NEAR(cutter.height(r), expected.height(r), 1e-7) << "at radius " << r;
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

/// Expects pieces from the axis outwards without gaps.
void expectRising(const std::vector<ProfilePiece>& pieces) {
    double r = 0;
    double z = 0;
    for (const ProfilePiece& piece : pieces) {
        EXPECT_DOUBLE_EQ(piece.r0, r);
        EXPECT_GE(piece.z0, z - 1e-12) << "walls go up";
        EXPECT_GT(piece.r1, piece.r0);
        EXPECT_GE(piece.z1, piece.z0);
        EXPECT_NEAR(heightOf(piece, piece.r0), piece.z0, 1e-9);
        EXPECT_NEAR(heightOf(piece, piece.r1), piece.z1, 1e-9);
        r = piece.r1;
        z = piece.z1;
    }
}

TEST(Cutter, PiecesJoinWithoutGapsAndRise) {
    for (const Expected& expected : kExpected) {
        SCOPED_TRACE(expected.spec);
        expectRising(parseCutter(expected.spec).value().pieces());
    }
    for (const CutterShape& shape : cutterShapes()) {
        SCOPED_TRACE(shape.key);
        expectRising(parseCutter(defaultSpecOf(shape)).value().pieces());
    }
}

struct ExpectedHead {
    const char* spec;
    double neck;
    double height;
    std::function<double(double)> back;
};

const ExpectedHead kHeads[] = {
    {"lollipop:d=10,neck=6", 3, 9, [](double r) { return 5 + std::sqrt(25 - r * r); }},
    {"tslot:d=20,w=4,neck=8", 4, 4, [](double) { return 4.0; }},
    {"tslot:d=20,w=4,neck=8,r=1", 4, 4, [](double r) { return r <= 9 ? 4 : 4 - ballOf(r - 9, 1); }},
    {"dovetail:d=20,angle=45,h=5", 5, 5, [](double r) { return 10 - r; }},
    {"dovetail:d=20,angle=45,h=5,neck=6", 3, 5, [](double r) { return std::min(5.0, 10 - r); }},
    {"dovetail:d=20,angle=45,h=5,neck=6,r=1", 3, 5,
     [](double r) {
         const double ring = 9;
         const double flank = ring + std::sqrt(0.5);
         return r <= flank ? std::min(5.0, 1 + std::sqrt(0.5) + flank - r)
                           : 1 + std::sqrt(1 - (r - ring) * (r - ring));
     }},
};

TEST(Cutter, BacksOfHeadsFollowTheFormulaOfTheShape) {
    for (const ExpectedHead& expected : kHeads) {
        SCOPED_TRACE(expected.spec);
        const Cutter cutter = parseCutter(expected.spec).value();
        ASSERT_TRUE(cutter.head());
        const std::vector<ProfilePiece>& back = cutter.head()->back;
        EXPECT_DOUBLE_EQ(cutter.head()->neckRadius, expected.neck);
        EXPECT_NEAR(cutter.profileHeight(), expected.height, 1e-12);
        EXPECT_DOUBLE_EQ(back.front().r0, expected.neck);
        EXPECT_DOUBLE_EQ(back.back().r1, cutter.radius());
        for (std::size_t k = 0; k < back.size(); ++k) {
            if (k > 0) {
                EXPECT_DOUBLE_EQ(back[k].r0, back[k - 1].r1);
                EXPECT_NEAR(back[k].z0, back[k - 1].z1, 1e-12);
            }
            for (int step = 0; step <= 20; ++step) {
                const double r = back[k].r0 + (back[k].r1 - back[k].r0) * step / 20;
                EXPECT_NEAR(heightOf(back[k], r), expected.back(r), 1e-7) << "at radius " << r;
            }
        }
    }
    for (const char* spec : {"ball:d=10", "taper:d=6,angle=5,h=20", "form:p=0/0:3/0"})
        EXPECT_FALSE(parseCutter(spec).value().head()) << spec;
}

/// Where an arc is vertical, kUprightPart of its radii count as its wall.
bool uprightAt(const ProfilePiece& arc, double r) {
    return r < arc.centreR - arc.radius + kUprightPart || r > arc.centreR + arc.radius - kUprightPart;
}

TEST(Cutter, LinesInPlaceOfAnArcAreNearItAndFew) {
    for (const auto& [spec, most] : {std::pair{"form:p=0/0:1/0:6/5@-5", 70},
                                     {"form:p=0/0:1/0:2/1@-1", 35},
                                     {"form:p=0/0:3/4@20", 40},
                                     {"form:p=0/0:1/0:101/100@-100", 310},
                                     {"form:p=0/0:5/0:8/20@-100", 70},
                                     {"form:p=0/0:5/0:8/20@85", 200}}) {
        SCOPED_TRACE(spec);
        const Cutter cutter = parseCutter(spec).value();
        const std::vector<ProfilePiece>& lines = cutter.solvablePieces();
        EXPECT_LE(static_cast<int>(lines.size()), most);
        const ProfilePiece& arc = cutter.pieces().back();
        for (const ProfilePiece& line : lines) {
            for (int step = 0; step <= 50; ++step) {
                const double r = line.r0 + (line.r1 - line.r0) * step / 50;
                if (line.r0 >= arc.r0 && !uprightAt(arc, r)) {
                    EXPECT_NEAR(heightOf(line, r), heightOf(arc, r), kProfileError * 1.001) << r;
                }
            }
        }
    }
}

TEST(Cutter, ArcsThatCuttingSolvesAreNotMadeLines) {
    for (const char* spec :
         {"ball:d=10", "taperball:d=4,angle=5,h=20", "bull:d=10,r=2", "form:p=0/0:1/0:3/2@2"}) {
        const Cutter cutter = parseCutter(spec).value();
        EXPECT_EQ(cutter.solvablePieces().size(), cutter.pieces().size()) << spec;
    }
}

} // namespace
} // namespace proveout
