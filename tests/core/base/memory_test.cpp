// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
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

/// availableMemoryBytes() of a child process under a resource limit.
std::uint64_t availableUnder(decltype(RLIMIT_AS) resource, std::uint64_t bytes) {
    std::array<int, 2> ends{};
    EXPECT_EQ(::pipe(ends.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit limit{bytes, bytes};
        const std::uint64_t available = ::setrlimit(resource, &limit) == 0 ? availableMemoryBytes() : 0;
        ::_exit(::write(ends[1], &available, sizeof available) == sizeof available ? 0 : 1);
    }
    ::close(ends[1]);
    std::uint64_t available = 0;
    EXPECT_EQ(::read(ends[0], &available, sizeof available), sizeof available);
    ::close(ends[0]);
    EXPECT_EQ(::waitpid(child, nullptr, 0), child);
    return available;
}

TEST(Memory, AvailableIsWhatResourceLimitsLeave) {
    constexpr std::uint64_t kGiven = 200'000'000;
    const std::uint64_t free = availableMemoryBytes();
    std::ifstream statm("/proc/self/statm");
    std::uint64_t pages = 0;
    statm >> pages;
    const std::uint64_t size = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    const std::uint64_t threads = std::max(1U, std::thread::hardware_concurrency()) * 80'000'000ULL;
    if (free < 2 * kGiven || size > (1ULL << 40U))
        GTEST_SKIP() << "too little memory, or a sanitizer that reserves addresses";
    const std::uint64_t left = availableUnder(RLIMIT_AS, size + threads + kGiven);
    EXPECT_LE(left, kGiven + threads / 4);
    EXPECT_GE(left, kGiven / 2);
    EXPECT_EQ(availableUnder(RLIMIT_AS, size), 0U) << "what is reserved already";
    EXPECT_LE(availableUnder(RLIMIT_DATA, kGiven), kGiven);
}

TEST(Memory, PeakRisesWithWhatIsTouched) {
    const auto before = peakMemoryBytes();
    const std::vector<char> taken(std::size_t{before} + 50'000'000, 'x');
    EXPECT_EQ(taken.back(), 'x');
    EXPECT_GE(peakMemoryBytes(), before + 50'000'000);
}

TEST(Memory, PeakIsThatOfTheProgramAndNotOfTheOneThatStartedIt) {
    const std::filesystem::path proc = std::filesystem::path(testing::TempDir()) / "proveout_peak";
    std::filesystem::create_directories(proc / "self");
    std::ofstream(proc / "self" / "status") << "Name:\tproveout cli\nUmask:\t0022\nVmPeak:\t  900 kB\n"
                                               "VmHWM:\t    120 kB\nVmRSS:\t    110 kB\n";
    MemorySources sources;
    sources.proc = proc;
    EXPECT_EQ(peakMemoryBytes(sources), 120U * 1024U);
    sources.proc = proc / "none";
    EXPECT_GT(peakMemoryBytes(sources), 1'000'000U) << "of this process";
    std::filesystem::remove_all(proc);
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
