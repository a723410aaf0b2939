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
#include <thread>
#include <unistd.h>

#include "core/base/control_groups.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace proveout {

namespace {

constexpr std::uint64_t kCautiousGuess = 1'000'000'000;
constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

/// The number that follows `key` in a file of lines "key value …"; nothing where there is none.
std::optional<std::uint64_t> numberOf(std::string_view wanted, const std::filesystem::path& file) {
    std::ifstream lines(file);
    std::string key;
    std::uint64_t number = 0;
    while (lines >> key) {
        if (key == wanted && lines >> number)
            return number;
        lines.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return std::nullopt;
}

/// Address space, resident and private memory of this process, bytes; a thread's stack counts as private.
struct ProcessSize {
    std::uint64_t addressSpace = 0;
    std::uint64_t resident = 0;
    std::uint64_t data = 0;
};

ProcessSize processSize(const std::filesystem::path& proc) {
    std::uint64_t total = 0;
    std::uint64_t resident = 0;
    std::uint64_t shared = 0;
    std::uint64_t text = 0;
    std::uint64_t libraries = 0;
    std::uint64_t data = 0;
    if (!(std::ifstream(proc / "self" / "statm") >> total >> resident >> shared >> text >> libraries >> data))
        return {};
    const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    return {total * page, resident * page, data * page};
}

std::uint64_t softLimit(decltype(RLIMIT_AS) resource) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return kNoLimit;
    return limit.rlim_cur;
}

std::uint64_t below(std::uint64_t limit, std::uint64_t used) {
    return limit == kNoLimit ? kNoLimit : limit - std::min(limit, used);
}

/// What `ulimit -v` and `ulimit -d` leave. Each thread reserves a stack, and glibc reserves an arena of 64
/// MiB of addresses for it, however little of them is used; the threads may not have been started yet.
std::uint64_t resourceLimitsLeave(const std::filesystem::path& proc) {
    constexpr std::uint64_t kArena = 64ULL << 20U;
    constexpr std::uint64_t kUsualStack = 8ULL << 20U;
    const std::uint64_t addresses = softLimit(RLIMIT_AS);
    const std::uint64_t data = softLimit(RLIMIT_DATA);
    if (addresses == kNoLimit && data == kNoLimit)
        return kNoLimit;
    const std::uint64_t threads = std::max(1U, std::thread::hardware_concurrency());
    const std::uint64_t stackLimit = softLimit(RLIMIT_STACK);
    const std::uint64_t stack = stackLimit == kNoLimit ? kUsualStack : stackLimit;
    const ProcessSize size = processSize(proc);
    return std::min(below(addresses, size.addressSpace + threads * (stack + kArena)),
                    below(data, size.data + threads * stack));
}

std::optional<std::uint64_t> machineBytes(std::string_view key, const std::filesystem::path& proc) {
    const auto kibibytes = numberOf(key, proc / "meminfo");
    return kibibytes ? std::optional(*kibibytes * 1024) : std::nullopt;
}

std::uint64_t ofMachine(const MemorySources& sources, const GroupMemory& groups) {
    return std::min(machineBytes("MemAvailable:", sources.proc).value_or(kCautiousGuess), groups.available);
}

std::uint64_t available(const MemorySources& sources, const GroupMemory& groups) {
    return std::min(ofMachine(sources, groups), resourceLimitsLeave(sources.proc));
}

} // namespace

std::uint64_t availableMemoryBytes(const MemorySources& sources) {
    return available(sources, controlGroupMemory(sources));
}

std::uint64_t machineMemoryBytes(const MemorySources& sources) {
    return ofMachine(sources, controlGroupMemory(sources));
}

std::uint64_t memoryLimitBytes(const MemorySources& sources) {
    const GroupMemory groups = controlGroupMemory(sources);
    const std::uint64_t installed = machineBytes("MemTotal:", sources.proc).value_or(kNoLimit);
    return std::min(available(sources, groups), std::min(installed, groups.limit) / 2);
}

std::uint64_t residentMemoryBytes(const MemorySources& sources) {
    return processSize(sources.proc).resident;
}

std::uint64_t peakMemoryBytes(const MemorySources& sources) {
    if (const auto kibibytes = numberOf("VmHWM:", sources.proc / "self" / "status"))
        return *kibibytes * 1024;
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0)
        return 0;
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

void returnLargeBlocksAtOnce() {
#ifdef __GLIBC__
    constexpr int kLarge = 1 << 20; // bytes
    ::mallopt(M_MMAP_THRESHOLD, kLarge);
#endif
}

void returnFreedMemory() {
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
}

std::string readableBytes(double bytes) {
    static constexpr std::array kUnits = {"B", "kB", "MB", "GB", "TB", "PB"};
    std::size_t unit = 0;
    // From 999.5 on, the figure would be rounded to 1000 of its unit.
    while (bytes >= 999.5 && unit + 1 < kUnits.size()) {
        bytes /= 1000;
        ++unit;
    }
    return bytes < 9.95 && unit > 0 ? fmt::format("{:.1f} {}", bytes, kUnits[unit])
                                    : fmt::format("{:.0f} {}", bytes, kUnits[unit]);
}

} // namespace proveout
