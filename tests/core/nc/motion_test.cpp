// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/program/motion.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/core/nc/random_arc.h"

namespace proveout {

using test::randomArc;
using test::uniform;

namespace {

constexpr double kPi = std::numbers::pi;

/// A point of an arc from the definition: angles by atan2, the radius linear.
Vec3 definedPoint(const Motion& motion, double t) {
    const PlaneAxes plane = axes(motion.plane);
    const auto radius = [&](const Vec3& p) {
        return std::hypot(p[plane.first] - motion.centre[plane.first],
                          p[plane.second] - motion.centre[plane.second]);
    };
    const double angle = std::atan2(motion.start[plane.second] - motion.centre[plane.second],
                                    motion.start[plane.first] - motion.centre[plane.first]) +
                         motion.sweep * t;
    const double r = radius(motion.start) * (1 - t) + radius(motion.end) * t;
    Vec3 point;
    point[plane.first] = motion.centre[plane.first] + r * std::cos(angle);
    point[plane.second] = motion.centre[plane.second] + r * std::sin(angle);
    point[plane.normal] = motion.start[plane.normal] * (1 - t) + motion.end[plane.normal] * t;
    return point;
}

} // namespace

TEST(Motion, PlanesAreRightHanded) {
    for (const Plane plane : {Plane::xy, Plane::zx, Plane::yz}) {
        Vec3 first(0);
        Vec3 second(0);
        Vec3 normal(0);
        first[axes(plane).first] = 1;
        second[axes(plane).second] = 1;
        normal[axes(plane).normal] = 1;
        EXPECT_EQ(glm::cross(first, second), normal);
    }
}

TEST(Motion, StraightPathsAreStraight) {
    Motion motion;
    motion.kind = MotionKind::feed;
    motion.start = Vec3(1, 2, 3);
    motion.end = Vec3(4, 6, 3);
    EXPECT_EQ(pathLength(motion), 5);
    EXPECT_EQ(pointAt(motion, 0.5), Vec3(2.5, 4, 3));
    EXPECT_EQ(bounds(motion).lo, Vec3(1, 2, 3));
    EXPECT_EQ(bounds(motion).hi, Vec3(4, 6, 3));
}

TEST(Motion, QuarterCircleHasItsLengthAndBox) {
    Motion motion;
    motion.kind = MotionKind::arc;
    motion.start = Vec3(10, 0, 0);
    motion.end = Vec3(0, 10, 0);
    motion.sweep = -1.5 * kPi;
    EXPECT_NEAR(pathLength(motion), 15 * kPi, 1e-12);
    EXPECT_EQ(arcRadius(motion), 10);
    EXPECT_NEAR(bounds(motion).lo.x, -10, 1e-12);
    EXPECT_NEAR(bounds(motion).lo.y, -10, 1e-12);
    EXPECT_NEAR(bounds(motion).hi.x, 10, 1e-12);
    EXPECT_NEAR(bounds(motion).hi.y, 10, 1e-12);
}

TEST(Motion, PointsOfArcsFollowTheDefinition) {
    for (unsigned seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        const Motion motion = randomArc(random, 0.01);
        EXPECT_EQ(pointAt(motion, 0), motion.start);
        EXPECT_EQ(pointAt(motion, 1), motion.end);
        for (int i = 0; i < 20; ++i) {
            const double t = uniform(random, 0, 1);
            EXPECT_LT(glm::length(pointAt(motion, t) - definedPoint(motion, t)), 1e-11);
        }
    }
}

TEST(Motion, LengthOfArcsIsThatOfAFinePolygon) {
    for (unsigned seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        const Motion motion = randomArc(random, 0.01);
        constexpr int kPieces = 20000;
        double length = 0;
        for (int i = 0; i < kPieces; ++i)
            length += glm::length(definedPoint(motion, (i + 1.0) / kPieces) -
                                  definedPoint(motion, i * 1.0 / kPieces));
        // The relative difference in length between an arc and its chord is the square of the angle over 24.
        const double angle = motion.sweep / kPieces;
        EXPECT_NEAR(pathLength(motion), length, length * (angle * angle / 24 * 1.1 + 1e-12));
    }
}

TEST(Motion, BoxOfArcsIsTight) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        const Motion motion = randomArc(random, seed % 2 == 0 ? 0.0 : 0.01);
        const Box3 box = bounds(motion);
        Box3 sampled;
        constexpr int kSamples = 20000;
        for (int i = 0; i <= kSamples; ++i)
            sampled.add(definedPoint(motion, static_cast<double>(i) / kSamples));
        const double angle = motion.sweep / kSamples;
        const double slack = arcRadius(motion) * angle * angle + 1e-10;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(box.lo[axis], sampled.lo[axis], slack);
            EXPECT_NEAR(box.hi[axis], sampled.hi[axis], slack);
            EXPECT_LE(box.lo[axis], sampled.lo[axis] + 1e-10);
            EXPECT_GE(box.hi[axis], sampled.hi[axis] - 1e-10);
        }
    }
}

} // namespace proveout
