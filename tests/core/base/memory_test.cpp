// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <vector>

namespace proveout {
namespace {

TEST(Memory, AvailableIsPartOfWhatTheMachineHas) {
    const auto installed = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                           static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    EXPECT_GT(availableMemoryBytes(), 10'000'000U);
    EXPECT_LE(availableMemoryBytes(), installed);
}

TEST(Memory, AJobMayTakeHalfOfTheMachineAtMost) {
    const auto installed = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                           static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    EXPECT_GT(memoryLimitBytes(), 10'000'000U);
    EXPECT_LE(memoryLimitBytes(), installed / 2);
}

TEST(Memory, PeakRisesWithWhatIsTouched) {
    const auto before = peakMemoryBytes();
    const std::vector<char> taken(std::size_t{before} + 50'000'000, 'x');
    EXPECT_EQ(taken.back(), 'x');
    EXPECT_GE(peakMemoryBytes(), before + 50'000'000);
}

TEST(Memory, SizesReadWell) {
    EXPECT_EQ(readableBytes(0), "0 B");
    EXPECT_EQ(readableBytes(999), "999 B");
    EXPECT_EQ(readableBytes(1000), "1.0 kB");
    EXPECT_EQ(readableBytes(9'960), "10 kB");
    EXPECT_EQ(readableBytes(999'600), "1.0 MB");
    EXPECT_EQ(readableBytes(320e6), "320 MB");
    EXPECT_EQ(readableBytes(1.5e12), "1.5 TB");
    EXPECT_EQ(readableBytes(5e18), "5000 PB");
}

} // namespace
} // namespace proveout
