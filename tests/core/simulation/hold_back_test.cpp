// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/hold_back.h"

#include <gtest/gtest.h>
#include <vector>

namespace proveout {
namespace {

/// The costs of a frame with and without decimation on a given machine and z-map.
struct Machine {
    double secondsPerFrame = 0; ///< for drawing, independent of the content
    double secondsPerFace = 0;
    double secondsPerRegion = 0; ///< for decimation
    std::size_t facesShown = 0;  ///< while decimating
    std::size_t facesFull = 0;
    std::size_t regions = 0;

    [[nodiscard]] FrameCost frame(bool held, double noise = 1) const {
        FrameCost cost;
        cost.facesFull = facesFull;
        cost.facesShown = held ? facesFull : facesShown;
        cost.regions = regions;
        cost.regionsDecimated = held ? 0 : 2;
        cost.decimationSeconds = held ? 0 : 2 * secondsPerRegion;
        cost.drawSeconds = noise * (secondsPerFrame + secondsPerFace * static_cast<double>(cost.facesShown));
        return cost;
    }
};

/// A million triangles on a card that draws ten million per second: decimation pays off.
constexpr Machine kSlowCard{1e-4, 1e-7, 1e-4, 100'000, 1'000'000, 2000};
/// The same z-map on a card for which triangles cost nothing.
constexpr Machine kFastCard{2e-4, 1e-12, 1e-4, 100'000, 1'000'000, 2000};

/// Plays the given number of frames; returns the frames after which the decision changed.
std::vector<int> play(HoldBack& holdBack, const Machine& machine, int frames) {
    std::vector<int> turns;
    for (int k = 0; k < frames; ++k)
        if (holdBack.add(machine.frame(holdBack.held(), k % 2 == 0 ? 0.99 : 1.01)))
            turns.push_back(k);
    return turns;
}

TEST(HoldBack, DecimatesWhereItPays) {
    HoldBack holdBack(5, kSlowCard.facesFull);
    EXPECT_FALSE(holdBack.held());
    int held = 0;
    for (int k = 0; k < 100'000; ++k) {
        (void)holdBack.add(kSlowCard.frame(holdBack.held()));
        held += holdBack.held() ? 1 : 0;
    }
    EXPECT_FALSE(holdBack.held());
    EXPECT_LT(held, 1000);
}

TEST(HoldBack, GivesUpAtOnceWhatCannotPay) {
    Machine machine = kFastCard;
    machine.secondsPerRegion = 2e-3; // 4 ms per frame; drawing all triangles could take at most 2 ms more
    HoldBack holdBack(5, machine.facesFull);
    const auto turns = play(holdBack, machine, 20);
    ASSERT_EQ(turns.size(), 1u);
    EXPECT_TRUE(holdBack.held());
    ASSERT_TRUE(holdBack.frameSeconds(true) && holdBack.frameSeconds(false));
    EXPECT_LT(*holdBack.frameSeconds(true), *holdBack.frameSeconds(false));
}

TEST(HoldBack, FindsByTrialThatDrawingCostsTheSame) {
    Machine machine = kFastCard;
    machine.regions = 50; // few enough for the cost of a trial
    machine.secondsPerRegion = 2e-5;
    HoldBack holdBack(5, machine.facesFull);
    (void)play(holdBack, machine, 3000);
    EXPECT_TRUE(holdBack.held());
    EXPECT_NEAR(*holdBack.frameSeconds(true), 2e-4, 1e-5);
    EXPECT_NEAR(*holdBack.frameSeconds(false), 2.4e-4, 1e-5);
}

TEST(HoldBack, BeginsHeldBackOnATinyMap) {
    EXPECT_TRUE(HoldBack(5, 2 * 19 * 19).held());
    EXPECT_FALSE(HoldBack(5, 2 * 99 * 99).held());
}

TEST(HoldBack, TriesAgainMoreAndMoreSeldom) {
    const Machine tiny{1e-3, 1e-9, 5e-5, 200, 722, 4};
    HoldBack holdBack(5, tiny.facesFull);
    int decimating = 0;
    std::vector<int> trials;
    constexpr int kFrames = 200'000;
    for (int k = 0; k < kFrames; ++k) {
        if (holdBack.add(tiny.frame(holdBack.held())) && !holdBack.held())
            trials.push_back(k);
        decimating += holdBack.held() ? 0 : 1;
    }
    EXPECT_TRUE(holdBack.held());
    ASSERT_GE(trials.size(), 4u);
    for (std::size_t k = 2; k < trials.size(); ++k)
        EXPECT_GT(trials[k] - trials[k - 1], 1.5 * (trials[k - 1] - trials[k - 2])) << k;
    EXPECT_LT(decimating, kFrames / 100);
}

TEST(HoldBack, ContinuesWhenItPaysAgain) {
    Machine machine{1e-3, 1e-9, 5e-5, 200, 722, 4};
    HoldBack holdBack(5, machine.facesFull);
    (void)play(holdBack, machine, 5000);
    ASSERT_TRUE(holdBack.held());
    machine.secondsPerFace = 1e-5;
    (void)play(holdBack, machine, 50'000);
    EXPECT_FALSE(holdBack.held());
}

TEST(HoldBack, DoesNotAlternateWhereBothCostTheSame) {
    Machine machine{1e-3, 1e-6, 0, 200, 3000, 4};
    machine.secondsPerRegion = 1e-6 * (3000 - 200) / 2;
    HoldBack holdBack(5, machine.facesFull);
    const auto turns = play(holdBack, machine, 100'000);
    EXPECT_LT(turns.size(), 24u);
}

TEST(HoldBack, HoldsNothingBackWhereNobodyDraws) {
    Machine machine = kFastCard;
    machine.secondsPerFrame = 0;
    machine.secondsPerFace = 0;
    HoldBack holdBack(5, machine.facesFull);
    EXPECT_TRUE(play(holdBack, machine, 10'000).empty());
    EXPECT_FALSE(holdBack.held());
}

} // namespace
} // namespace proveout
