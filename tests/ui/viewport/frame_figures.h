// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace proveout {

struct FrameFigures {
    double simulate = 0; ///< seconds: cutting, decimation, bookkeeping
    double upload = 0;
    double draw = 0;
    std::size_t triangles = 0;
    std::size_t bytes = 0;

    [[nodiscard]] double total() const { return simulate + upload + draw; }
};

/// Prints mean times, triangles and bytes of the frames of the given number of equal runs.
void printSums(const char* name, const std::vector<FrameFigures>& frames, int pairs);
/// Prints the 50th, 95th and 99th percentile of the frame time, and their ratio.
void printPercentiles(const std::vector<FrameFigures>& with, const std::vector<FrameFigures>& without);
/// Prints the frames in which `figure` is larger with decimation than without; returns their number. Frame k
/// belongs to block k * every.
std::size_t compare(const char* name, const std::vector<FrameFigures>& with,
                    const std::vector<FrameFigures>& without, std::size_t every,
                    std::size_t FrameFigures::*figure);

} // namespace proveout
