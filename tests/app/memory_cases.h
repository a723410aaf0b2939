// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the real program whose peak of memory is compared with what it forecast.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace proveout {

/// A run that is to be accepted, and whose memory is mostly that of its map.
struct MemoryCase {
    std::string arguments; ///< of proveout-cli; the inputs are those of writeMemoryInputs()
    bool isQuick = false;  ///< one of the share that every test run goes through
};

/// Stocks with and without holes, methods, meshes, formats, records, provenance, boxes, grids and threads.
[[nodiscard]] const std::vector<MemoryCase>& memoryCases();

/// Writes the programs and maps that the cases read.
void writeMemoryInputs(const std::filesystem::path& folder);

struct MemoryRun {
    int exitCode = -1; ///< -1: ended by a signal
    double peakBytes = 0;
    double forecastBytes = 0; ///< as its JSON has it; 0: it has none
    double seconds = 0;
    std::string errors; ///< what it wrote to stderr
};

/// Runs the program in `folder` and waits for it. The peak is the one that the system reports.
[[nodiscard]] MemoryRun runForMemory(const std::filesystem::path& program,
                                     const std::filesystem::path& folder, const std::string& arguments);

/// What a run takes whatever the size of its map: the program with its libraries and threads.
[[nodiscard]] double smallestPeakBytes(const std::filesystem::path& program,
                                       const std::filesystem::path& folder);

/// The promise: a run is never killed, and takes at most this times what it forecast.
inline constexpr double kMostOfForecast = 1.2;

/// Why the run breaks the promise; empty where it does not.
[[nodiscard]] std::string brokenPromise(const MemoryRun& run, double smallestPeak);

} // namespace proveout
