// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the straight pieces of arcs with the arc at many points in between.
#include "core/nc/motions/turned_arc.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "tests/core/nc/random_arc.h"
#include "tests/random_seed.h"

namespace proveout::test {

namespace {

double distance(const Vec3& point, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square == 0 ? 0 : std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0);
    return glm::length(a + along * t - point);
}

} // namespace

TEST(TurnedArc, LiesWithinTheChordErrorOfItsPieces) {
    const unsigned seed = randomSeed();
    std::mt19937 random(seed);
    for (int round = 0; round < 300; ++round) {
        const Motion arc = randomArc(random, 1e-3);
        const std::vector<Vec3> ends = piecesOfArc(arc, kChordError);
        ASSERT_EQ(ends.back(), arc.end) << "seed " << seed;
        constexpr int kBetween = 7;
        Vec3 last = arc.start;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (int k = 0; k <= kBetween; ++k) {
                const double t = (static_cast<double>(i) + static_cast<double>(k) / kBetween) /
                                 static_cast<double>(ends.size());
                ASSERT_LE(distance(pointAt(arc, t), last, ends[i]), kChordError)
                    << "seed " << seed << " round " << round;
            }
            last = ends[i];
        }
    }
}

} // namespace proveout::test
