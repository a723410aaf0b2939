// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the real program whose peak memory is compared with the forecast.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace proveout {

/// A run that must be accepted, and whose memory is used mostly by its map.
struct MemoryCase {
    std::string arguments; ///< of proveout-cli; the inputs are those of writeMemoryInputs()
    bool isQuick = false;  ///< included in the share that every test run executes
};

/// Stocks with and without holes, methods, meshes, formats, records, provenance, detail regions, grids and
/// threads.
[[nodiscard]] const std::vector<MemoryCase>& memoryCases();

/// Writes the programs and maps that the cases use.
void writeMemoryInputs(const std::filesystem::path& folder);

struct MemoryRun {
    int exitCode = -1; ///< -1: ended by a signal
    double peakBytes = 0;
    double forecastBytes = 0; ///< from its JSON; 0: not present
    double seconds = 0;
    std::string errors; ///< its output on stderr
};

/// Runs the program in `folder` and waits for it. The peak is the one reported by the system.
[[nodiscard]] MemoryRun runForMemory(const std::filesystem::path& program,
                                     const std::filesystem::path& folder, const std::string& arguments);

/// The memory of a run independent of the size of its map: the program with its libraries and threads.
[[nodiscard]] double smallestPeakBytes(const std::filesystem::path& program,
                                       const std::filesystem::path& folder);

/// The guarantee: a run is never killed, and uses at most this factor times its forecast.
inline constexpr double kMostOfForecast = 1.2;

/// Why the run violates the guarantee; empty if it does not.
[[nodiscard]] std::string brokenPromise(const MemoryRun& run, double smallestPeak);

} // namespace proveout
