// SPDX-License-Identifier: GPL-3.0-or-later
// Compares flattened splines with the definition by basis functions (Cox and de Boor), which spline.cpp does
// not use.
#include "core/nc/geometry/spline.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <random>

#include "core/nc/program/motion.h"
#include "tests/random_seed.h"

namespace proveout {

namespace {

std::vector<double> knotsOf(const Spline& spline) {
    const int n = static_cast<int>(spline.points.size()) - 1;
    std::vector<double> knots;
    for (int i = 0; i <= n + spline.order; ++i)
        knots.push_back(std::clamp(i - spline.order + 1, 0, n - spline.order + 2));
    return knots;
}

double basis(const std::vector<double>& knots, std::size_t i, int order, double t) {
    if (order == 1) {
        const bool last = t == knots.back() && knots[i + 1] == t;
        return knots[i] < knots[i + 1] && t >= knots[i] && (t < knots[i + 1] || last) ? 1 : 0;
    }
    const auto part = [&](double above, double below, double value) {
        return below == 0 ? 0 : above / below * value;
    };
    const std::size_t k = static_cast<std::size_t>(order);
    return part(t - knots[i], knots[i + k - 1] - knots[i], basis(knots, i, order - 1, t)) +
           part(knots[i + k] - t, knots[i + k] - knots[i + 1], basis(knots, i + 1, order - 1, t));
}

Vec2 pointOf(const Spline& spline, const std::vector<double>& knots, double t) {
    Vec2 sum(0);
    double weights = 0;
    for (std::size_t i = 0; i < spline.points.size(); ++i) {
        const double b = basis(knots, i, spline.order, t) * spline.points[i].weight;
        sum += spline.points[i].at * b;
        weights += b;
    }
    return sum / weights;
}

double distance(const Vec2& point, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square == 0 ? 0 : std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0);
    return glm::length(a + along * t - point);
}

double distance(const Vec2& point, const std::vector<Vec2>& path) {
    double least = INFINITY;
    for (std::size_t i = 1; i < path.size(); ++i)
        least = std::min(least, distance(point, path[i - 1], path[i]));
    return least;
}

Spline randomSpline(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-50, 50);
    std::uniform_real_distribution<double> weight(0.2, 5);
    Spline spline;
    spline.order = std::uniform_int_distribution(3, 6)(random);
    const int count = spline.order + std::uniform_int_distribution(0, 5)(random);
    const bool rational = std::bernoulli_distribution(0.5)(random);
    for (int i = 0; i < count; ++i)
        spline.points.push_back({{place(random), place(random)}, rational ? weight(random) : 1});
    return spline;
}

std::vector<Vec2> pathOf(const Spline& spline, double chordError) {
    std::vector<Vec2> path{spline.points.front().at};
    const auto points = flattened(spline, chordError);
    EXPECT_TRUE(points);
    path.insert(path.end(), points->begin(), points->end());
    return path;
}

/// The parameter after `from` at which the spline passes a point: pieces are halved, so it is at a half, a
/// quarter … of the distance between two knots. Empty if the spline passes the point at none of these.
std::optional<double> parameterOf(const Vec2& point, const Spline& spline, const std::vector<double>& knots,
                                  double from) {
    for (double step = 1; step > 1e-9; step /= 2) {
        const double next = from + step;
        if (next <= knots.back() && glm::distance(pointOf(spline, knots, next), point) < 1e-9)
            return next;
    }
    return {};
}

} // namespace

TEST(Spline, LiesWithinTheChordErrorOfItsMotions) {
    const unsigned seed = randomSeed();
    std::mt19937 random(seed);
    constexpr double kError = 0.05; // coarse, so that all of the few pieces can be checked
    for (int round = 0; round < 100; ++round) {
        const Spline spline = randomSpline(random);
        const std::vector<double> knots = knotsOf(spline);
        const std::vector<Vec2> path = pathOf(spline, kError);
        EXPECT_EQ(path.back(), spline.points.back().at) << "seed " << seed;
        for (int i = 0; i <= 1000; ++i) {
            const Vec2 point = pointOf(spline, knots, knots.back() * i / 1000);
            ASSERT_LE(distance(point, path), kError * (1 + 1e-9)) << "seed " << seed << " round " << round;
        }
        double at = 0;
        for (std::size_t i = 1; i < path.size(); ++i) {
            const auto next = parameterOf(path[i], spline, knots, at);
            ASSERT_TRUE(next) << "seed " << seed << " round " << round << " point " << i;
            at = *next;
        }
        EXPECT_EQ(at, knots.back()) << "seed " << seed << " round " << round;
    }
}

TEST(Spline, IsACircleWithTheWeightsOfOne) {
    // A quarter circle of radius 10 as a quadratic rational Bézier curve.
    const Spline quarter{{{{10, 0}}, {{10, 10}, std::sqrt(0.5)}, {{0, 10}}}, 3};
    const std::vector<Vec2> path = pathOf(quarter, kChordError);
    for (std::size_t i = 0; i < path.size(); ++i) {
        EXPECT_NEAR(glm::length(path[i]), 10, 1e-12);
        const Vec2& before = path[i == 0 ? 0 : i - 1];
        EXPECT_GT(glm::length(path[i] + before) / 2, 10 - kChordError);
    }
    EXPECT_LT(path.size(), 200U);
}

TEST(Spline, OfPointsInALineIsOneMotion) {
    EXPECT_EQ(flattened({{{{0, 0}}, {{1, 1}}, {{2, 2}}, {{5, 5}}}, 4}, kChordError)->size(), 1U);
    EXPECT_EQ(flattened({{{{3, 4}}, {{3, 4}}, {{3, 4}}}, 3}, kChordError)->size(), 1U);
}

TEST(Spline, IsRefusedBeyondItsLimit) {
    EXPECT_FALSE(flattened({{{{0, 0}}, {{1e12, 1e12}}, {{2e12, 0}}}, 3}, kChordError));
}

} // namespace proveout
