// SPDX-License-Identifier: GPL-3.0-or-later
// cutting_table: prints the tables of tests/bench/cutting.md as Markdown, with the name of the machine. Every
// value is measured in a separate process, so that its memory can be measured too.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <numbers>
#include <oneapi/tbb/global_control.h>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "core/base/memory.h"
#include "core/base/stop_watch.h"
#include "tests/bench/in_a_process.h"
#include "tests/bench/workloads.h"
#include "tests/core/cutter/default_spec.h"

namespace proveout::bench {
namespace {

/// Measurements of a child process; a plain struct, because it is sent through a pipe.
struct Figures {
    double seconds = 0;
    double processorSeconds = 0;
    double points = 0;
    double peakBytes = 0;
};

Figures measuredApart(const std::function<Figures()>& measure) {
    return inAProcess([&] {
        Figures made = measure();
        made.peakBytes = static_cast<double>(peakMemoryBytes());
        return made;
    });
}

void say(const std::string& line) {
    std::puts(line.c_str());
    std::fflush(stdout);
}

// --- the machine

/// The value of the first line of a file that begins with `key`.
std::string valueOf(const char* file, const std::string& key) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        const auto colon = line.find(':');
        if (line.starts_with(key) && colon != std::string::npos)
            return line.substr(line.find_first_not_of(" \t", colon + 1));
    }
    return "unknown";
}

void reportMachine() {
    say(fmt::format("Machine: {}, {} threads, memory {}.\n", valueOf("/proc/cpuinfo", "model name"),
                    std::thread::hardware_concurrency(), valueOf("/proc/meminfo", "MemTotal")));
}

// --- shapes

enum class Kind { level, sloped, arc, helix, upright };
constexpr std::array kKinds = {Kind::level, Kind::sloped, Kind::arc, Kind::helix, Kind::upright};

class RandomMotions {
public:
    Motion make(Kind kind) {
        Motion motion;
        motion.kind = MotionKind::feed;
        motion.startKnown = motion.endKnown = kAllAxes;
        const Vec3 place(uniform(25, 175), uniform(25, 175), uniform(-20, -2));
        const double angle = uniform(-std::numbers::pi, std::numbers::pi);
        motion.start = place;
        motion.end = place + 12.0 * Vec3(std::cos(angle), std::sin(angle), 0);
        if (kind == Kind::sloped)
            motion.end.z += uniform(-3, 3);
        if (kind == Kind::arc || kind == Kind::helix)
            makeRound(motion, place, angle, kind == Kind::helix ? -1.0 : 0.0);
        if (kind == Kind::upright)
            makeUpright(motion, place);
        return motion;
    }

private:
    double uniform(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(m_random); }

    void makeRound(Motion& motion, const Vec3& centre, double angle, double climb) {
        const double radius = uniform(4, 12);
        motion.kind = MotionKind::arc;
        motion.centre = centre;
        motion.sweep = uniform(0.5, 6);
        motion.start = centre + radius * Vec3(std::cos(angle), std::sin(angle), 0);
        motion.end =
            centre + radius * Vec3(std::cos(angle + motion.sweep), std::sin(angle + motion.sweep), 0);
        motion.end.z += climb;
    }
    /// A valley of a quarter turn.
    void makeUpright(Motion& motion, const Vec3& lowest) {
        const double radius = uniform(8, 16);
        const double half = std::numbers::pi / 4;
        motion.kind = MotionKind::arc;
        motion.plane = Plane::zx;
        motion.centre = lowest + Vec3(0, 0, radius);
        motion.start = motion.centre + radius * Vec3(-std::sin(half), 0, -std::cos(half));
        motion.end = motion.centre + radius * Vec3(std::sin(half), 0, -std::cos(half));
        motion.centre.z = motion.start.z + radius * std::cos(half);
        motion.sweep = -2 * half;
    }

    std::mt19937 m_random{5};
};

double processorSeconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Motions one by one, with records, on one thread; the fastest of several rounds.
Figures measureShape(const Cutter& cutter, Kind kind) {
    constexpr int kRounds = 5;
    constexpr int kMotions = 200;
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    const StockBox stock{{0, 0, 0}, 200, 200, 40};
    const Grid grid = makeGrid(stock, 0.1).value();
    Figures best;
    for (int round = 0; round < kRounds; ++round) {
        ZMap zmap(stock, grid);
        RandomMotions motions;
        const double begin = processorSeconds();
        double points = 0;
        for (int k = 0; k < kMotions; ++k)
            points += static_cast<double>(cut(zmap, cutter, motions.make(kind)).points);
        const double seconds = processorSeconds() - begin;
        if (round == 0 || seconds < best.processorSeconds)
            best = {seconds, seconds, points, 0};
    }
    return best;
}

void reportShapes() {
    say("Million grid points lowered a second and core, by shape; 200 random motions of 12 mm or an arc at "
        "0.1 mm,\none by one, with records:\n");
    say("| cutter | level | sloped | arc | helix | upright arc |\n|---|---|---|---|---|---|");
    for (const CutterShape& shape : cutterShapes()) {
        const std::string spec = defaultSpecOf(shape);
        const Cutter cutter = parseCutter(spec).value();
        std::string row = fmt::format("| `{}` |", spec);
        for (const Kind kind : kKinds) {
            const Figures done = measuredApart([&] { return measureShape(cutter, kind); });
            row += fmt::format(" {:.0f} |", done.points / done.processorSeconds / 1e6);
        }
        say(row);
    }
    say("");
}

// --- workloads

enum class Mode { heights, records, provenance };

Figures measureWorkload(const Workload& workload, double spacing, Mode mode, std::size_t threads,
                        std::size_t most) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const Cutter cutter = parseCutter(fmt::format("ball:d={}", workload.diameter)).value();
    std::vector<CutterMotion> motions = motionsOf(workload, cutter);
    motions.resize(std::min(most, motions.size()));
    for (std::size_t k = 0; k < motions.size(); ++k)
        motions[k].mark = static_cast<std::uint32_t>(k + 1);
    const Grid grid = makeGrid(stockOf(workload), spacing).value();
    ZMap zmap(stockOf(workload), grid);
    std::vector<Provenance> provenance;
    if (mode == Mode::provenance)
        provenance.emplace_back(zmap);
    const StopWatch watch;
    if (mode == Mode::heights)
        (void)cutHeights(zmap, motions, {});
    else
        (void)cut(zmap, motions, {}, provenance.empty() ? nullptr : provenance.data());
    return {watch.seconds(), 0, static_cast<double>(grid.nx) * grid.ny, 0};
}

Figures ofWorkload(const Workload& workload, double spacing, Mode mode, std::size_t threads,
                   std::size_t most = static_cast<std::size_t>(-1)) {
    return measuredApart([&] { return measureWorkload(workload, spacing, mode, threads, most); });
}

std::size_t blocksOf(const Workload& workload) {
    return static_cast<std::size_t>(workload.lines) * static_cast<std::size_t>(workload.perLine);
}

void reportWorkloads() {
    say("Ball-end finishing at 0.1 mm: seconds for heights alone, with a record of each block, and with "
        "records and\nprovenance; blocks a second with records on two threads; the largest memory of the "
        "process, its motions\n(168 bytes a block) included:\n");
    say("| blocks, million points | heights, 1 thread | 2 | records, 1 thread | 2 | and provenance, 2 | "
        "blocks/s | heights, bytes a point | records, MB |\n|---|---|---|---|---|---|---|---|---|");
    for (const Workload& workload : workloads()) {
        const Figures heights = ofWorkload(workload, 0.1, Mode::heights, 1);
        const Figures heightsOnTwo = ofWorkload(workload, 0.1, Mode::heights, 2);
        const Figures records = ofWorkload(workload, 0.1, Mode::records, 1);
        const Figures recordsOnTwo = ofWorkload(workload, 0.1, Mode::records, 2);
        const Figures marked = ofWorkload(workload, 0.1, Mode::provenance, 2);
        const auto blocks = static_cast<double>(blocksOf(workload));
        say(fmt::format(
            "| {}, {:.1f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.0f} | {:.1f} | {:.0f} |", blocks,
            heights.points / 1e6, heights.seconds, heightsOnTwo.seconds, records.seconds,
            recordsOnTwo.seconds, marked.seconds, blocks / recordsOnTwo.seconds,
            heights.peakBytes / heights.points, recordsOnTwo.peakBytes / 1e6));
    }
    say("");
}

// --- growth

void reportGrowth() {
    const Workload& die = workloads()[2];
    say(fmt::format("Growth with the grid: {} blocks, seconds on one thread:\n", blocksOf(die)));
    say("| spacing, mm | million points | heights | records |\n|---|---|---|---|");
    for (const double spacing : {0.8, 0.4, 0.2, 0.1, 0.05}) {
        const Figures heights = ofWorkload(die, spacing, Mode::heights, 1);
        const Figures records = ofWorkload(die, spacing, Mode::records, 1);
        say(fmt::format("| {} | {:.2f} | {:.3f} | {:.3f} |", spacing, heights.points / 1e6, heights.seconds,
                        records.seconds));
    }
    const Workload& panel = workloads()[3];
    say("\nGrowth with the blocks: the first of the largest workload at 0.25 mm, seconds on one thread:\n");
    say("| blocks | heights | records |\n|---|---|---|");
    for (const std::size_t blocks : {10'500U, 105'000U, 1'050'000U}) {
        const Figures heights = ofWorkload(panel, 0.25, Mode::heights, 1, blocks);
        const Figures records = ofWorkload(panel, 0.25, Mode::records, 1, blocks);
        say(fmt::format("| {} | {:.3f} | {:.3f} |", blocks, heights.seconds, records.seconds));
    }
}

} // namespace
} // namespace proveout::bench

int main() {
    using namespace proveout::bench;
    reportMachine();
    reportShapes();
    reportWorkloads();
    reportGrowth();
    return 0;
}
