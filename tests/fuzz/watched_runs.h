// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that may crash, hang or take all memory, in a process of their own, each of them measured.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace proveout::test {

/// What a run may take. Seconds are those of the processor, of all threads, so that a busy machine changes
/// nothing; memory is what the process has resident at most.
struct RunLimits {
    double seconds = 5;
    std::uint64_t bytes = 1'000'000'000;
};

enum class RunEnd : std::uint8_t { notRun, done, crashed, threw, tooSlow, tooLarge };

struct WatchedRun {
    RunEnd end = RunEnd::notRun;
    bool accepted = false; ///< what the run returned
    double seconds = 0;
    std::uint64_t peakBytes = 0;
};

/// Calls `run` with 0 … count−1, in order, in child processes: one as long as nothing goes wrong, and the
/// next after each run that crashed or was stopped. Linux.
[[nodiscard]] std::vector<WatchedRun> watchRuns(std::size_t count, const RunLimits& limits,
                                                const std::function<bool(std::size_t)>& run);

/// "crashed", "over 5 s", …
[[nodiscard]] std::string sentenceOf(const WatchedRun& run, const RunLimits& limits);

} // namespace proveout::test
