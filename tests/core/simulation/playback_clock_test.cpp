// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/playback_clock.h"

#include <gtest/gtest.h>
#include <limits>

namespace proveout {
namespace {

using namespace std::chrono_literals;

TEST(PlaybackClock, CountsBlocksByTime) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.start(100, 50, start);
    EXPECT_EQ(clock.due(start), 100U);
    EXPECT_EQ(clock.due(start + 1s), 150U);
    EXPECT_EQ(clock.due(start - 1s), 100U);
    EXPECT_EQ(clock.next(100, start), start + 20ms);
    EXPECT_EQ(clock.next(99, start), start);
}

TEST(PlaybackClock, KnowsNoHurryAndNoEnd) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.start(3, std::numeric_limits<double>::infinity(), start);
    EXPECT_GT(clock.due(start), std::size_t{1} << 60);
    EXPECT_EQ(clock.next(3, start + 1s), start + 1s);
    for (const double rate : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        clock.start(3, rate, start);
        EXPECT_EQ(clock.due(start + 100s), 3U);
        EXPECT_EQ(clock.next(3, start), start + 60s);
    }
    clock.start(3, 1e300, start);
    EXPECT_GT(clock.due(start + 1s), 1'000'000U);
}

TEST(PlaybackClock, OwesNothingAfterASlowBlock) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.start(0, 10, start);
    // Block 1 takes 3 s: 30 blocks are due, and none of them is caught up.
    clock.reached(1, start + 3s);
    EXPECT_EQ(clock.due(start + 3s), 1U);
    EXPECT_EQ(clock.next(1, start + 3s), start + 3s + 100ms);
}

TEST(PlaybackClock, KeepsItsRateThroughSlicesOfWork) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.start(0, 1000, start);
    for (auto now = start; now < start + 2s; now += 10ms)
        clock.reached(clock.due(now), now + 8ms); // the work of a slice takes most of it
    EXPECT_EQ(clock.due(start + 2s), 2000U);
}

} // namespace
} // namespace proveout
