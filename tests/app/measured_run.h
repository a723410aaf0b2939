// SPDX-License-Identifier: GPL-3.0-or-later
// The real program in a process of its own, measured by the system.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace proveout {

struct MeasuredRun {
    int exitCode = 0; ///< below 0: the signal that ended it
    double seconds = 0;
    double cpuSeconds = 0; ///< of all its threads
    double peakBytes = 0;  ///< resident
};

/// Runs `words`, the program first, in `folder`. What it writes stands there in `out.json` and `err.txt`. It
/// is ended after `longestSeconds`; 0: never. Throws where it cannot be started.
[[nodiscard]] MeasuredRun runMeasured(std::vector<std::string> words, const std::filesystem::path& folder,
                                      unsigned longestSeconds = 0);

} // namespace proveout
