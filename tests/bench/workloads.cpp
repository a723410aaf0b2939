// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/workloads.h"

#include <cmath>
#include <fmt/format.h>

namespace proveout::bench {

namespace {

constexpr Workload kWorkloads[] = {
    {"mould", 140, 140, 11, 15, 17},
    {"mouse", 140, 100, 11, 99, 104},
    {"die", 500, 500, 20, 359, 359},
    {"panel", 2000, 1000, 20, 700, 1500},
};

double surface(const Vec2& at) {
    return -12 + 5 * std::sin(at.x / 37) * std::cos(at.y / 29) + 2 * std::sin((at.x + at.y) / 11);
}

} // namespace

std::span<const Workload> workloads() {
    return kWorkloads;
}

StockBox stockOf(const Workload& workload) {
    return {{0, 0, 0}, workload.width, workload.depth, 40};
}

std::vector<CutterMotion> motionsOf(const Workload& workload, const Cutter& cutter) {
    const auto place = [&](int line, int step) {
        const double part =
            static_cast<double>(line % 2 == 0 ? step : workload.perLine - step) / workload.perLine;
        const Vec2 at(workload.width * part, workload.depth * line / (workload.lines - 1));
        return Vec3(at, surface(at));
    };
    std::vector<CutterMotion> motions;
    motions.reserve(static_cast<std::size_t>(workload.lines) * static_cast<std::size_t>(workload.perLine));
    Vec3 last = place(0, 0);
    for (int line = 0; line < workload.lines; ++line)
        for (int step = 1; step <= workload.perLine; ++step) {
            Motion motion;
            motion.kind = MotionKind::feed;
            motion.startKnown = motion.endKnown = kAllAxes;
            motion.start = last;
            motion.end = place(line, step);
            last = motion.end;
            motions.push_back({&cutter, motion});
            motions.back().continues = motions.size() > 1;
        }
    return motions;
}

std::string programOf(const Workload& workload) {
    const Cutter none;
    std::string text = "G21 G90 G17 G94\nT1 M6\nG43 H1\nS10000 M3 F2000\n";
    const auto motions = motionsOf(workload, none);
    const Vec3& first = motions.front().motion.start;
    text += fmt::format("G0 Z20\nG0 X{:.4f} Y{:.4f}\nG1 Z{:.4f}\n", first.x, first.y, first.z);
    for (const CutterMotion& one : motions) {
        const Vec3& end = one.motion.end;
        text += fmt::format("X{:.4f} Y{:.4f} Z{:.4f}\n", end.x, end.y, end.z);
    }
    return text + "G0 Z20\nM30\n";
}

} // namespace proveout::bench
