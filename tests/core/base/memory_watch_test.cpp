// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory_watch.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

namespace proveout {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t kMegabyte = 1'000'000;

/// Whether the watch stops the work in time; only a failure waits that long.
bool stopsWithin(const MemoryWatch& watch, std::chrono::seconds most) {
    const auto end = std::chrono::steady_clock::now() + most;
    while (!watch.exceeded() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(1ms);
    return watch.exceeded();
}

TEST(MemoryWatch, StopsWorkThatTakesMoreThanItMay) {
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "sanitizers take memory of their own";
#endif
    const MemoryWatch watch(residentMemoryBytes() + 100 * kMegabyte);
    std::vector<std::vector<char>> taken;
    for (int k = 0; k < 50; ++k)
        taken.emplace_back(kMegabyte, 'x'); // written, so it is resident
    EXPECT_FALSE(stopsWithin(watch, 0s));
    std::this_thread::sleep_for(50ms);
    EXPECT_FALSE(watch.exceeded());
    for (int k = 0; k < 100; ++k)
        taken.emplace_back(kMegabyte, 'x');
    EXPECT_TRUE(stopsWithin(watch, 20s));
    EXPECT_TRUE(watch.stop().stop_requested());
}

TEST(MemoryWatch, ContinuesWorkThatIsNotTheCause) {
    const MemoryWatch innocent(0, [] { return false; });
    const MemoryWatch guilty(0, [] { return true; });
    EXPECT_TRUE(guilty.exceeded());
    std::this_thread::sleep_for(50ms);
    EXPECT_FALSE(innocent.exceeded());
}

TEST(MemoryWatch, EndsWithoutWaitingForItsNextLook) {
    const auto begin = std::chrono::steady_clock::now();
    { const MemoryWatch watch(residentMemoryBytes() + 1000 * kMegabyte, {}, 1h); }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 60s);
}

} // namespace
} // namespace proveout
