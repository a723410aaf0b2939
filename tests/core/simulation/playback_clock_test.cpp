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

} // namespace
} // namespace proveout
