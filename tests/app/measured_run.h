// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the real program in a process of its own, measured by the system.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace proveout {

struct MeasuredRun {
    int exitCode = 0; ///< negative: the signal that ended it
    double seconds = 0;
    double cpuSeconds = 0; ///< of all its threads
    double peakBytes = 0;  ///< resident memory
};

/// Runs `words`, the program first, in `folder`. Its output is written there to `out.json` and `err.txt`. It
/// is killed after `longestSeconds`; 0: never. Throws if it cannot be started.
[[nodiscard]] MeasuredRun runMeasured(std::vector<std::string> words, const std::filesystem::path& folder,
                                      unsigned longestSeconds = 0);

} // namespace proveout
