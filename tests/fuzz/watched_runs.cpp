// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/watched_runs.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <limits>
#include <malloc.h>
#include <memory>
#include <new>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <type_traits>
#include <unistd.h>

namespace proveout::test {

namespace {

/// A run that waits uses no CPU time; it is stopped after this many seconds of wall time.
constexpr double kLongestWait = 120;
/// Bytes of address space of a child: more than a run may use, and too little to harm the machine.
constexpr std::uint64_t kAddressSpace = 6'000'000'000;
/// Freed memory that the child keeps would hide the memory used by the next run.
constexpr std::uint64_t kTrimFrom = 64'000'000;
constexpr std::chrono::milliseconds kGlance(5);

/// Memory shared by parent and child.
struct Shared {
    std::atomic<std::size_t> current{0};
    std::atomic<double> startedAt{0}; ///< CPU seconds of the child
    std::atomic<double> startedClock{0};
};

double secondsOf(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Memory shared by both processes. The system provides the pages, so values are initially zero.
template<class Value>
class SharedArray {
public:
    explicit SharedArray(std::size_t count) : m_bytes(count * sizeof(Value)) {
        void* pages = mmap(nullptr, m_bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (pages == MAP_FAILED)
            throw std::bad_alloc();
        m_values = static_cast<Value*>(pages);
        std::uninitialized_value_construct_n(m_values, count);
    }
    ~SharedArray() { munmap(m_values, m_bytes); }
    SharedArray(const SharedArray&) = delete;
    SharedArray& operator=(const SharedArray&) = delete;

    Value& operator[](std::size_t index) const { return m_values[index]; }

private:
    std::size_t m_bytes;
    Value* m_values;
};

/// Writing 5 there makes Linux reset the peak.
void resetPeak() {
    std::ofstream("/proc/self/clear_refs") << 5;
}

std::uint64_t peakBytes() {
    std::ifstream status("/proc/self/status");
    for (std::string key; status >> key;) {
        std::uint64_t kibibytes = 0;
        if (key == "VmHWM:" && status >> kibibytes)
            return kibibytes * 1024;
        status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return 0;
}

RunEnd endOf(const WatchedRun& run, const RunLimits& limits) {
    if (run.seconds > limits.seconds)
        return RunEnd::tooSlow;
    return run.peakBytes > limits.bytes ? RunEnd::tooLarge : RunEnd::done;
}

RunEnd endOfCall(const std::function<bool(std::size_t)>& run, std::size_t index, bool& accepted) {
    try {
        accepted = run(index);
        return RunEnd::done;
    } catch (const std::bad_alloc&) {
        return RunEnd::tooLarge;
    } catch (const std::exception& exception) {
        std::fprintf(stderr, "run %zu: %s\n", index, exception.what());
        return RunEnd::threw;
    }
}

/// Runs in the child: all runs from `first` on.
[[noreturn]] void work(std::size_t first, std::size_t count, const RunLimits& limits,
                       const std::function<bool(std::size_t)>& run, Shared& shared,
                       const SharedArray<WatchedRun>& results) {
    const rlimit space{kAddressSpace, kAddressSpace};
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_AS, &space);
    setrlimit(RLIMIT_CORE, &noCore);
    for (std::size_t index = first; index < count; ++index) {
        resetPeak();
        const double start = secondsOf(CLOCK_PROCESS_CPUTIME_ID);
        shared.startedAt = start;
        shared.startedClock = secondsOf(CLOCK_MONOTONIC);
        shared.current = index;
        WatchedRun result;
        result.end = endOfCall(run, index, result.accepted);
        result.seconds = secondsOf(CLOCK_PROCESS_CPUTIME_ID) - start;
        result.peakBytes = peakBytes();
        if (result.end == RunEnd::done)
            result.end = endOf(result, limits);
        results[index] = result;
        if (result.peakBytes > kTrimFrom)
            malloc_trim(0);
    }
    _exit(0);
}

/// Waits for the child; kills it if its current run takes too long.
bool endsWell(pid_t child, const RunLimits& limits, const Shared& shared, bool& stopped) {
    clockid_t clock{};
    clock_getcpuclockid(child, &clock);
    for (;;) {
        int status = 0;
        if (waitpid(child, &status, WNOHANG) == child)
            return WIFEXITED(status) && WEXITSTATUS(status) == 0;
        const bool slow = secondsOf(clock) - shared.startedAt > 2 * limits.seconds;
        const bool waits = secondsOf(CLOCK_MONOTONIC) - shared.startedClock > kLongestWait;
        if ((slow || waits) && !stopped) {
            stopped = true;
            kill(child, SIGKILL);
        }
        std::this_thread::sleep_for(kGlance);
    }
}

} // namespace

std::vector<WatchedRun> watchRuns(std::size_t count, const RunLimits& limits,
                                  const std::function<bool(std::size_t)>& run) {
    const SharedArray<Shared> shared(1);
    const SharedArray<WatchedRun> results(count);
    for (std::size_t next = 0; next < count;) {
        shared[0].current = next;
        shared[0].startedAt = 0;
        shared[0].startedClock = secondsOf(CLOCK_MONOTONIC);
        std::fflush(nullptr);
        const pid_t child = fork();
        if (child < 0)
            throw std::bad_alloc();
        if (child == 0)
            work(next, count, limits, run, shared[0], results);
        bool stopped = false;
        if (endsWell(child, limits, shared[0], stopped))
            break;
        next = shared[0].current;
        results[next].end = stopped ? RunEnd::tooSlow : RunEnd::crashed;
        results[next].seconds = stopped ? 2 * limits.seconds : 0;
        ++next;
    }
    std::vector<WatchedRun> all;
    for (std::size_t index = 0; index < count; ++index)
        all.push_back(results[index]);
    return all;
}

std::string sentenceOf(const WatchedRun& run, const RunLimits& limits) {
    switch (run.end) {
    case RunEnd::crashed:
        return "crashed";
    case RunEnd::threw:
        return "ended with an exception";
    case RunEnd::tooSlow:
        return "took over " + std::to_string(static_cast<int>(limits.seconds)) + " s";
    case RunEnd::tooLarge:
        return "took over " + std::to_string(limits.bytes / 1'000'000) + " MB";
    case RunEnd::notRun:
    case RunEnd::done:
        break;
    }
    return "ended well";
}

} // namespace proveout::test
