// SPDX-License-Identifier: GPL-3.0-or-later
// Chamfers and corner radii between random paths, checked by their definitions.
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>

#include "core/nc/geometry/corner_shape.h"
#include "tests/core/nc/random_arc.h"
#include "tests/core/nc/random_path.h"
#include "tests/random_seed.h"

namespace proveout::test {

namespace {

constexpr double kExact = 1e-7;
constexpr int kPaths = 2000;

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Expects that two consecutive paths are tangent where they meet.
void expectSmooth(const PlanePath& before, const PlanePath& after) {
    EXPECT_LT(glm::distance(before.end, after.start), kExact);
    EXPECT_LT(glm::distance(headingAtEnd(before), headingAtStart(after)), kExact);
}

bool hasLength(const PlanePath& path) {
    return path.arc() ? std::abs(path.sweep) > 1e-6 : glm::distance(path.start, path.end) > 1e-6;
}

} // namespace

TEST(CornerShape, RoundingsTouchBothPaths) {
    const auto seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    int made = 0;
    for (int i = 0; i < kPaths && !HasFailure(); ++i) {
        const auto paths = randomPath(random, {3, 5, 40, 2.8, 0.05, 5, 3});
        const double radius = uniform(random, 0.1, 6);
        const auto arc = roundingBetween(paths[1], paths[2], radius);
        if (!arc || needsNoCorner(paths[1], paths[2]))
            continue;
        const PlanePath before = upTo(paths[1], arc->start);
        const PlanePath after = fromOn(paths[2], arc->end);
        if (!hasLength(before) || !hasLength(after))
            continue;
        ++made;
        EXPECT_NEAR(glm::distance(arc->start, arc->centre), radius, kExact);
        EXPECT_NEAR(glm::distance(arc->end, arc->centre), radius, kExact);
        expectSmooth(before, *arc);
        expectSmooth(*arc, after);
        EXPECT_LE(std::abs(before.sweep), std::abs(paths[1].sweep) + kExact);
        EXPECT_LE(std::abs(after.sweep), std::abs(paths[2].sweep) + kExact);
    }
    std::cout << fmt::format("seed {}, {} of {} corners rounded\n", seed, made, kPaths);
    EXPECT_GT(made, kPaths / 3);
}

TEST(CornerShape, ChamfersBeginAndEndAtTheirLength) {
    const auto seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    for (int i = 0; i < kPaths && !HasFailure(); ++i) {
        const auto paths = randomPath(random, {3, 5, 40, 2.8, 0.05, 5, 3});
        const double length = uniform(random, 0.1, 4);
        const auto chamfer = chamferBetween(paths[1], paths[2], length);
        if (!chamfer)
            continue;
        EXPECT_NEAR(glm::distance(chamfer->start, paths[1].end), length, kExact);
        EXPECT_NEAR(glm::distance(chamfer->end, paths[2].start), length, kExact);
        for (const auto& [path, point] : {std::pair{paths[1], chamfer->start}, {paths[2], chamfer->end}}) {
            const double off =
                path.arc() ? glm::distance(point, path.centre) - glm::distance(path.start, path.centre)
                           : cross(headingAtStart(path), point - path.start);
            EXPECT_NEAR(off, 0, kExact);
        }
    }
}

TEST(CornerShape, WhatDoesNotFitIsNothing) {
    const PlanePath along{{0, 0}, {10, 0}, Vec2(0), 0};
    const PlanePath up{{10, 0}, {10, 5}, Vec2(0), 0};
    EXPECT_TRUE(chamferBetween(along, up, 5));
    EXPECT_FALSE(chamferBetween(along, up, 5.001));
    EXPECT_TRUE(roundingBetween(along, up, 5));
    EXPECT_FALSE(roundingBetween(along, up, 5.001));
    EXPECT_TRUE(needsNoCorner(along, {{10, 0}, {20, 0.1}, Vec2(0), 0}));
}

} // namespace proveout::test
