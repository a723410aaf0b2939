// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/viewport/frame_figures.h"

#include <algorithm>
#include <cstdio>

namespace proveout {

namespace {

constexpr int kReported = 10; ///< number of failing frames that are listed; further ones are only counted

double percentile(const std::vector<double>& sorted, int percent) {
    return sorted[(sorted.size() - 1) * static_cast<std::size_t>(percent) / 100];
}

std::vector<double> sortedTimes(const std::vector<FrameFigures>& frames) {
    std::vector<double> times;
    for (const FrameFigures& frame : frames)
        times.push_back(frame.total());
    std::ranges::sort(times);
    return times;
}

} // namespace

void printSums(const char* name, const std::vector<FrameFigures>& frames, int pairs) {
    FrameFigures sum;
    double triangles = 0;
    double bytes = 0;
    for (const FrameFigures& frame : frames) {
        sum.simulate += frame.simulate;
        sum.upload += frame.upload;
        sum.draw += frame.draw;
        triangles += static_cast<double>(frame.triangles);
        bytes += static_cast<double>(frame.bytes);
    }
    const auto count = static_cast<double>(frames.size());
    std::printf("%-20s %8.2f s a run = cutting and decimation %7.3f + upload %7.3f + drawing %8.2f   "
                "%8.0f triangles and %8.0f bytes a frame\n",
                name, sum.total() / pairs, sum.simulate / pairs, sum.upload / pairs, sum.draw / pairs,
                triangles / count, bytes / count);
}

void printPercentiles(const std::vector<FrameFigures>& with, const std::vector<FrameFigures>& without) {
    const auto a = sortedTimes(with);
    const auto b = sortedTimes(without);
    for (const int percent : {50, 95, 99})
        std::printf("p%d of a frame        %8.3f ms / %8.3f ms = %6.3f\n", percent,
                    1e3 * percentile(a, percent), 1e3 * percentile(b, percent),
                    percentile(a, percent) / percentile(b, percent));
}

std::size_t compare(const char* name, const std::vector<FrameFigures>& with,
                    const std::vector<FrameFigures>& without, std::size_t every,
                    std::size_t FrameFigures::*figure) {
    std::size_t broken = 0;
    double excess = 0;
    for (std::size_t k = 0; k < with.size(); ++k) {
        const std::size_t a = with[k].*figure;
        const std::size_t b = without[k].*figure;
        if (a <= b)
            continue;
        excess += static_cast<double>(a - b);
        if (++broken <= kReported)
            std::printf("block %zu: %zu %s with decimation, %zu without\n", k * every, a, name, b);
    }
    std::printf("%s: more on %zu of %zu frames, %.0f in all\n", name, broken, with.size(), excess);
    return broken;
}

} // namespace proveout
