// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>
#include <sys/resource.h>

namespace proveout {

namespace {

constexpr std::uint64_t kCautiousGuess = 1'000'000'000;
constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

/// The number behind `key` in a file of lines "key number …"; nothing where there is none.
std::optional<std::uint64_t> numberOf(std::string_view wanted, const char* file) {
    std::ifstream lines(file);
    std::string key;
    std::uint64_t number = 0;
    while (lines >> key >> number) {
        if (key == wanted)
            return number;
        lines.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return std::nullopt;
}

/// A container may have less than its machine, and is killed at its own limit. What it uses counts the files
/// the system keeps in memory for speed, which it gives up when asked. No limit ("max") is no number.
std::uint64_t containerAvailable() {
    std::uint64_t limit = 0;
    std::uint64_t used = 0;
    if (!(std::ifstream("/sys/fs/cgroup/memory.max") >> limit) ||
        !(std::ifstream("/sys/fs/cgroup/memory.current") >> used))
        return kNoLimit;
    for (const char* cache : {"inactive_file", "active_file"})
        used -= std::min(used, numberOf(cache, "/sys/fs/cgroup/memory.stat").value_or(0));
    return limit - std::min(limit, used);
}

} // namespace

std::uint64_t availableMemoryBytes() {
    const auto kibibytes = numberOf("MemAvailable:", "/proc/meminfo");
    return std::min(kibibytes ? *kibibytes * 1024 : kCautiousGuess, containerAvailable());
}

std::uint64_t memoryLimitBytes() {
    std::uint64_t installed = kNoLimit;
    if (const auto kibibytes = numberOf("MemTotal:", "/proc/meminfo"))
        installed = *kibibytes * 1024;
    std::uint64_t container = 0;
    if (std::ifstream("/sys/fs/cgroup/memory.max") >> container)
        installed = std::min(installed, container);
    return std::min(availableMemoryBytes(), installed / 2);
}

std::uint64_t peakMemoryBytes() {
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0)
        return 0;
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

std::string readableBytes(double bytes) {
    static constexpr std::array kUnits = {"B", "kB", "MB", "GB", "TB", "PB"};
    std::size_t unit = 0;
    // 999.5 is where the figure would be rounded to 1000 of its unit.
    while (bytes >= 999.5 && unit + 1 < kUnits.size()) {
        bytes /= 1000;
        ++unit;
    }
    return bytes < 9.95 && unit > 0 ? fmt::format("{:.1f} {}", bytes, kUnits[unit])
                                    : fmt::format("{:.0f} {}", bytes, kUnits[unit]);
}

} // namespace proveout
