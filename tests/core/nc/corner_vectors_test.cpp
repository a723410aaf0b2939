// SPDX-License-Identifier: GPL-3.0-or-later
// The vectors at corners, compared with the figures of Fanuc's manuals.
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "core/nc/geometry/corner_vectors.h"

namespace proveout {

namespace {

constexpr double kExact = 1e-9;
constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 5;

PlanePath line(const Vec2& start, const Vec2& end) {
    return {start, end, Vec2(0), 0};
}

void expectPoints(const CornerPoints& points, const std::vector<Vec2>& expected) {
    ASSERT_EQ(points.all().size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_LT(glm::distance(points.all()[i], expected[i]), kExact) << i;
}

const PlanePath kAlongX = line({-20, 0}, {0, 0});
const PlanePath kUp = line({0, 0}, {0, 20});
const PlanePath kDown = line({0, 0}, {0, -20});
const PlanePath kSharpBack = line({0, 0}, {-20, -20});
/// Clockwise around a centre to the left of the start, so it starts downwards.
const PlanePath kArcDown{{0, 0}, {-20, -20}, {-20, 0}, -kPi / 2};

} // namespace

TEST(CornerVectors, StartUpOfTypeA) {
    for (const PlanePath& after : {kUp, kDown, kSharpBack, kArcDown}) {
        const Vec2 square = beside(after.start, headingAtStart(after), kRadius);
        expectPoints(startUpPoints(kAlongX, after, kRadius, false), {square});
    }
}

TEST(CornerVectors, StartUpOfTypeB) {
    const double half = kRadius * std::numbers::sqrt2 / 2;
    expectPoints(startUpPoints(kAlongX, kUp, kRadius, true), {{-5, 0}});
    expectPoints(startUpPoints(kAlongX, kDown, kRadius, true), {{5, 5}});
    expectPoints(startUpPoints(kAlongX, kSharpBack, kRadius, true), {{5, 5}, {2 * half, 0}});
    expectPoints(startUpPoints(kAlongX, kArcDown, kRadius, true), {{5, 5}, {5, 0}});
}

TEST(CornerVectors, CancelOfTypeA) {
    for (const PlanePath& after : {kUp, kDown, kSharpBack})
        expectPoints(cancelPoints(kAlongX, after, kRadius, false), {{0, 5}});
}

TEST(CornerVectors, CancelOfTypeB) {
    const double half = kRadius * std::numbers::sqrt2 / 2;
    const PlanePath arc{{0, 20}, {20, 0}, {0, 0}, -kPi / 2};
    expectPoints(cancelPoints(kAlongX, kUp, kRadius, true), {{0, 5}});
    expectPoints(cancelPoints(kAlongX, kDown, kRadius, true), {{5, 5}});
    expectPoints(cancelPoints(kAlongX, kSharpBack, kRadius, true), {{5, 5}, {2 * half, 0}});
    expectPoints(cancelPoints(arc, line({20, 0}, {0, 0}), kRadius, true), {{25, 0}, {25, -5}});
}

TEST(CornerVectors, LinesThatTurnBackByLessThanADegreeAreNotRoundedByTypeB) {
    const PlanePath back = line({0, 0}, {-20, -0.3});
    const Vec2 square = beside(Vec2(0), headingAtStart(back), kRadius);
    expectPoints(startUpPoints(kAlongX, back, kRadius, true), {square});
    expectPoints(cancelPoints(kAlongX, back, kRadius, true), {{0, 5}});
}

TEST(CornerVectors, CirclesThatTouchLeaveTheToolBetweenThem) {
    const PlanePath first{{0, 0}, {40, 0}, {20, 0}, -kPi};
    const PlanePath second{{40, 0}, {80, 0}, {60, 0}, -kPi};
    const auto inside = cornerPoints(first, second, kRadius);
    ASSERT_TRUE(inside);
    expectPoints(*inside, {{40, 15}});
    const auto outside = cornerPoints(first, second, -kRadius);
    ASSERT_TRUE(outside);
    expectPoints(*outside, {{35, 0}, {35, -5}, {45, -5}, {45, 0}});
}

TEST(CornerVectors, SmallMovesAreLeftOutButBeforeHalfATurn) {
    CornerPoints points;
    points.add({0, 0});
    points.add({0.0009, -0.0009});
    points.add({0.0009, 0.002});
    expectPoints(withoutSmallMoves(points, 1e-3, kArcDown), {{0, 0}, {0.0009, 0.002}});
    PlanePath half = kArcDown;
    half.sweep = -kPi;
    expectPoints(withoutSmallMoves(points, 1e-3, half), {{0, 0}, {0.0009, -0.0009}, {0.0009, 0.002}});
}

TEST(CornerVectors, ArcsThatWouldTurnBackAreReported) {
    const PlanePath arc{{10, 0}, {0, 10}, {0, 0}, kPi / 2};
    const Vec2 third(10 * std::cos(kPi / 6), 10 * std::sin(kPi / 6));
    const Vec2 sixth(10 * std::cos(kPi / 3), 10 * std::sin(kPi / 3));
    EXPECT_NEAR(trimmedSweep(arc, third, sixth), kPi / 6, kExact);
    EXPECT_FALSE(goesBackward(arc, third, sixth));
    EXPECT_TRUE(goesBackward(arc, sixth, third));
    EXPECT_TRUE(goesBackward(kAlongX, {-5, 5}, {-10, 5}));
    EXPECT_FALSE(goesBackward(kAlongX, {-10, 5}, {-10, 5}));
}

} // namespace proveout
