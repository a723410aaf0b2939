// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/time/velocity_plan.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <random>

#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr double kPi = std::numbers::pi;

PathPiece straight(const Vec3& direction, double length, double speed, double acceleration) {
    PathPiece piece;
    piece.length = length;
    piece.topSpeed = speed;
    piece.acceleration = acceleration;
    piece.startDirection = piece.endDirection = glm::normalize(direction);
    return piece;
}

std::vector<double> times(const std::vector<PathPiece>& pieces, double deviation) {
    std::vector<double> seconds(pieces.size(), -1);
    VelocityPlan plan(deviation, [&](std::uint32_t owner, double time) { seconds[owner] = time; });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        PathPiece piece = pieces[i];
        piece.owner = static_cast<std::uint32_t>(i);
        plan.add(piece);
    }
    plan.stop();
    return seconds;
}

double total(const std::vector<PathPiece>& pieces, double deviation) {
    const auto each = times(pieces, deviation);
    return std::accumulate(each.begin(), each.end(), 0.0);
}

TEST(VelocityPlan, OneMoveIsATrapezoidOrATriangle) {
    // 100 mm at 50 mm/s and 500 mm/s²: 0.1 s for each ramp, which together take 5 mm, and 95 mm at full
    // speed.
    EXPECT_NEAR(total({straight({1, 0, 0}, 100, 50, 500)}, 0.02), 0.2 + 95 / 50.0, 1e-12);
    // 1 mm: the peak speed is sqrt(a·L), and the time is twice that over a.
    EXPECT_NEAR(total({straight({0, 1, 1}, 1, 50, 500)}, 0.02), 2 * std::sqrt(1.0 / 500), 1e-12);
}

TEST(VelocityPlan, ManyPiecesInOneDirectionAreOneMove) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> length(1e-3, 1);
    std::vector<PathPiece> pieces;
    double sum = 0;
    for (int i = 0; i < 50'000; ++i) { // more than are planned at once
        pieces.push_back(straight({3, -1, 0.5}, length(random), 80, 1000));
        sum += pieces.back().length;
    }
    const double whole = total({straight({3, -1, 0.5}, sum, 80, 1000)}, 0);
    EXPECT_NEAR(total(pieces, 0), whole, 1e-9 * whole);
}

TEST(VelocityPlan, ACornerIsPassedAtItsLimit) {
    const std::vector<PathPiece> corner{straight({1, 0, 0}, 100, 50, 500), straight({0, 1, 0}, 100, 50, 500)};
    // With no tolerance it stops at the corner: two separate moves.
    EXPECT_NEAR(total(corner, 0), 2 * (0.2 + 95 / 50.0), 1e-12);
    // v² = a·d·s/(1 - s), where s is the sine of half the corner angle, 45°.
    const double half = std::sqrt(0.5);
    const double v = std::sqrt(500 * 0.02 * half / (1 - half));
    ASSERT_LT(v, 50);
    const double braking = (50 - v) / 500;
    const double each = 0.1 + braking + (100 - 2.5 - (2500 - v * v) / 1000) / 50;
    EXPECT_NEAR(total(corner, 0.02), 2 * each, 1e-12);
    // A reversal stops, however large the tolerance.
    EXPECT_NEAR(total({corner[0], straight({-1, 0, 0}, 100, 50, 500)}, 10), 2 * (0.2 + 95 / 50.0), 1e-12);
}

TEST(VelocityPlan, APolylineOfACircleIsAsFastAsTheCircle) {
    // With ever shorter chords: never faster than the centripetal acceleration allows.
    constexpr double kRadius = 5;
    constexpr double kAcceleration = 500;
    const double limit = std::sqrt(kAcceleration * kRadius);
    for (const int chords : {2000, 20'000}) {
        std::vector<PathPiece> pieces;
        for (int i = 0; i < chords * 10; ++i) {
            const double angle = 2 * kPi * i / chords;
            pieces.push_back(straight({std::cos(angle), std::sin(angle), 0},
                                      2 * kRadius * std::sin(kPi / chords), 1000, kAcceleration));
        }
        const double way = 10 * 2 * kPi * kRadius;
        // The time at the limit, plus the loss from both ramps.
        const double expected = way / limit + limit / kAcceleration;
        EXPECT_NEAR(total(pieces, 0.02), expected, 0.01 * expected) << chords;
    }
}

/// Applies the same rules to a path cut into very many short steps, by brute force: first the speeds that
/// braking allows after each step, then those that acceleration allows.
double steppedTotal(const std::vector<PathPiece>& pieces, double deviation) {
    constexpr int kSteps = 400;
    std::vector<double> limit;
    std::vector<double> length;
    std::vector<double> acceleration;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        double corner = 0;
        if (i > 0) {
            const double angle =
                kPi - std::acos(std::clamp(glm::dot(pieces[i - 1].endDirection, pieces[i].startDirection),
                                           -1.0, 1.0));
            const double a = std::min(pieces[i - 1].acceleration, pieces[i].acceleration);
            const double s = std::sin(angle / 2);
            corner =
                std::min({std::pow(std::min(pieces[i - 1].topSpeed, pieces[i].topSpeed), 2),
                          a * deviation * s / (1 - s),
                          a * std::min(pieces[i - 1].length, pieces[i].length) / 2 * std::tan(angle / 2)});
        }
        for (int step = 0; step < kSteps; ++step) {
            limit.push_back(step == 0 ? corner : pieces[i].topSpeed * pieces[i].topSpeed);
            length.push_back(pieces[i].length / kSteps);
            acceleration.push_back(pieces[i].acceleration);
        }
    }
    limit.push_back(0);
    for (std::size_t i = length.size(); i-- > 0;)
        limit[i] = std::min(limit[i], limit[i + 1] + 2 * acceleration[i] * length[i]);
    double time = 0;
    double speed = 0;
    for (std::size_t i = 0; i < length.size(); ++i) {
        const double next =
            std::sqrt(std::min(limit[i + 1], speed * speed + 2 * acceleration[i] * length[i]));
        // Within a step the speed may rise and fall, so the mean of its ends is slightly too slow.
        time += length[i] / std::max((speed + next) / 2, 1e-12);
        speed = next;
    }
    return time;
}

TEST(VelocityPlan, AgreesWithSmallSteps) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto between = [&random](double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    for (int path = 0; path < 60; ++path) {
        std::vector<PathPiece> pieces;
        Vec3 direction(1, 0, 0);
        for (int i = 0; i < 60; ++i) {
            // Mostly straight on, sometimes around a corner.
            const double turn = random() % 4 == 0 ? between(-2, 2) : between(-0.2, 0.2);
            direction = glm::normalize(Vec3(direction.x * std::cos(turn) - direction.y * std::sin(turn),
                                            direction.x * std::sin(turn) + direction.y * std::cos(turn),
                                            between(-0.2, 0.2)));
            pieces.push_back(
                straight(direction, std::exp(between(-3, 4)), between(5, 200), between(200, 3000)));
        }
        const double deviation = path % 3 == 0 ? 0.002 : 0.05;
        const double expected = steppedTotal(pieces, deviation);
        ASSERT_NEAR(total(pieces, deviation), expected, 0.006 * expected) << "path " << path;
    }
}

TEST(VelocityPlan, PlansInPartsWhatItWouldPlanAtOnce) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> turn(-0.3, 0.3);
    std::vector<PathPiece> pieces;
    double angle = 0;
    for (int i = 0; i < 60'000; ++i) {
        angle += turn(random);
        pieces.push_back(straight({std::cos(angle), std::sin(angle), 0}, 0.05, 100, 400));
    }
    // Two corners that stop the machine, so that each part is planned within one portion.
    const auto whole = times(pieces, 0.02);
    for (std::size_t i = 0; i < whole.size(); ++i)
        ASSERT_GT(whole[i], 0) << i;
    // The middle, far enough from both ends that they have no effect.
    const std::vector<PathPiece> middle(pieces.begin() + 15'000, pieces.begin() + 20'000);
    const auto part = times(middle, 0.02);
    for (std::size_t i = 1000; i < 4000; ++i)
        ASSERT_NEAR(part[i], whole[15'000 + i], 1e-12) << i;
}

} // namespace
} // namespace proveout
