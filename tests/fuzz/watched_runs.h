// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that may crash, hang or exhaust the memory, in processes of their own; each run is measured.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace proveout::test {

/// The limits of a run. Seconds are CPU time of all threads, so other load on the machine does not matter;
/// memory is the peak of the resident memory.
struct RunLimits {
    double seconds = 5;
    std::uint64_t bytes = 1'000'000'000;
};

enum class RunEnd : std::uint8_t { notRun, done, crashed, threw, tooSlow, tooLarge };

struct WatchedRun {
    RunEnd end = RunEnd::notRun;
    bool accepted = false; ///< the result of the run
    double seconds = 0;
    std::uint64_t peakBytes = 0;
};

/// Calls `run` with 0 … count−1, in sequence, in child processes: a new one only after a run that crashed or
/// was stopped. Linux only.
[[nodiscard]] std::vector<WatchedRun> watchRuns(std::size_t count, const RunLimits& limits,
                                                const std::function<bool(std::size_t)>& run);

/// "crashed", "over 5 s", …
[[nodiscard]] std::string sentenceOf(const WatchedRun& run, const RunLimits& limits);

} // namespace proveout::test
