// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/playback_clock.h"

#include <gtest/gtest.h>
#include <limits>

namespace proveout {
namespace {

using namespace std::chrono_literals;

/// The block after which playback should be.
std::size_t dueBlock(const PlaybackClock& clock, std::size_t from, PlaybackClock::Time now) {
    while (clock.isDue(from, now))
        ++from;
    return from;
}

TEST(PlaybackClock, CountsBlocksByTime) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.start(100, 50, start);
    EXPECT_EQ(dueBlock(clock, 100, start), 100U);
    EXPECT_EQ(dueBlock(clock, 100, start + 1s), 150U);
    EXPECT_EQ(dueBlock(clock, 100, start - 1s), 100U);
    EXPECT_EQ(clock.next(100, start), start + 20ms);
    EXPECT_EQ(clock.next(99, start), start);
}

TEST(PlaybackClock, GoesByAMeasure) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.setMeasure(std::make_shared<const PlaybackMeasure>(PlaybackMeasure{0, 10, 10, 11, 15}));
    clock.start(0, 2, start); // units per second
    EXPECT_EQ(dueBlock(clock, 0, start + 4999ms), 0U);
    EXPECT_EQ(dueBlock(clock, 0, start + 5s), 2U); // the second block takes no time
    EXPECT_EQ(clock.next(2, start), start + 5500ms);
    EXPECT_EQ(dueBlock(clock, 0, start + 7500ms), 4U);
    // After the end of the measure, blocks take the mean of the others.
    EXPECT_EQ(clock.next(4, start + 7500ms), start + 7500ms + 1875ms);
    clock.start(2, 2, start);
    EXPECT_EQ(clock.next(2, start), start + 500ms);
}

TEST(PlaybackClock, AMeasureOfNothingIsPlayedAtOnce) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.setMeasure(std::make_shared<const PlaybackMeasure>(PlaybackMeasure{0}));
    clock.start(0, 1, start);
    EXPECT_TRUE(clock.isDue(0, start));
    EXPECT_TRUE(clock.isDue(1000, start));
}

TEST(PlaybackClock, ReportsWhichPartOfItsSpeedItKeeps) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.start(0, 100, start);
    std::size_t block = 0;
    auto now = start;
    for (; now < start + 2s; now += 40ms)
        clock.reached(block = dueBlock(clock, block, now), now);
    EXPECT_DOUBLE_EQ(clock.keptPart(), 1); // late at times, but it always catches up
    for (; now < start + 6s; now += 100ms)
        clock.reached(++block, now); // ten blocks per second instead of a hundred
    EXPECT_NEAR(clock.keptPart(), 0.1, 0.03);
    clock.start(block, 100, now);
    EXPECT_DOUBLE_EQ(clock.keptPart(), 1);
}

TEST(PlaybackClock, KnowsNoHurryAndNoEnd) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.start(3, std::numeric_limits<double>::infinity(), start);
    EXPECT_TRUE(clock.isDue(std::size_t{1} << 60, start));
    EXPECT_EQ(clock.next(3, start + 1s), start + 1s);
    for (const double rate : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        clock.start(3, rate, start);
        EXPECT_FALSE(clock.isDue(3, start + 100s));
        EXPECT_EQ(clock.next(3, start), start + 60s);
    }
    clock.start(3, 1e300, start);
    EXPECT_TRUE(clock.isDue(1'000'000, start + 1s));
}

TEST(PlaybackClock, OwesNothingAfterASlowBlock) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.start(0, 10, start);
    // Block 1 takes 3 s: 30 blocks are due, but the clock does not catch up.
    clock.reached(1, start + 3s);
    EXPECT_EQ(dueBlock(clock, 1, start + 3s), 1U);
    EXPECT_EQ(clock.next(1, start + 3s), start + 3s + 100ms);
}

TEST(PlaybackClock, KeepsItsRateThroughSlicesOfWork) {
    const PlaybackClock::Time start{};
    PlaybackClock clock;
    clock.start(0, 1000, start);
    std::size_t block = 0;
    for (auto now = start; now < start + 2s; now += 10ms)
        clock.reached(block = dueBlock(clock, block, now), now + 8ms); // the work takes most of a slice
    EXPECT_EQ(dueBlock(clock, block, start + 2s), 2000U);
}

} // namespace
} // namespace proveout
