// SPDX-License-Identifier: GPL-3.0-or-later
// Million grid points per second under the sweep of one motion, per shape and kind of motion, at 0.1 mm.
#include <benchmark/benchmark.h>
#include <cmath>
#include <numbers>
#include <oneapi/tbb/global_control.h>

#include "core/cutting/cut/cutting.h"

namespace proveout {
namespace {

const StockBox kStock{{0, 0, 0}, 100, 80, 1000};
constexpr double kSpacing = 0.1;

enum Kind { level, sloped, arc, helix, verticalArc };

Motion motionOf(Kind kind) {
    Motion motion;
    motion.kind = MotionKind::feed;
    motion.startKnown = kAllAxes;
    motion.endKnown = kAllAxes;
    motion.start = {15, 20, -2};
    motion.end = {85, 55, kind == level ? -2.0 : -5.0};
    if (kind == arc || kind == helix) {
        motion.kind = MotionKind::arc;
        motion.centre = {50, 40, -2};
        motion.start = {75, 40, -2};
        motion.end = {25, 40, kind == arc ? -2.0 : -5.0};
        motion.sweep = std::numbers::pi;
    }
    if (kind == verticalArc) {
        motion.kind = MotionKind::arc;
        motion.plane = Plane::zx;
        motion.start = {20, 40, -10};
        motion.end = {80, 40, -10};
        motion.centre = {50, 40, 30};
        motion.sweep = -2 * std::atan2(30.0, 40.0);
    }
    return motion;
}

void cutOne(benchmark::State& state, const char* spec, Kind kind) {
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    const Cutter cutter = parseCutter(spec).value();
    ZMap zmap(kStock, makeGrid(kStock, kSpacing).value());
    Motion motion = motionOf(kind);
    // Each round is slightly deeper, so that every point under the sweep is lowered each time.
    const double deeper = 1e-4;
    const auto points = static_cast<double>(cut(zmap, cutter, motion).points);
    for (auto _ : state) {
        motion.start.z -= deeper;
        motion.end.z -= deeper;
        motion.centre.z -= deeper;
        benchmark::DoNotOptimize(cut(zmap, cutter, motion));
    }
    state.counters["Mpoints/s"] = benchmark::Counter(points * static_cast<double>(state.iterations()) / 1e6,
                                                     benchmark::Counter::kIsRate);
}

/// A short block on a coarse grid, as in the samples: the minimum cost of a motion.
void cutShort(benchmark::State& state, const char* spec) {
    const Cutter cutter = parseCutter(spec).value();
    ZMap zmap(kStock, makeGrid(kStock, 1).value());
    Motion motion = motionOf(sloped);
    motion.end = motion.start + Vec3(1, 0.3, -0.1);
    for (auto _ : state) {
        motion.start.z -= 1e-5;
        motion.end.z -= 1e-5;
        benchmark::DoNotOptimize(cut(zmap, cutter, motion));
    }
}

#define PROVEOUT_CUT_BENCH(name, spec)                                                                       \
    BENCHMARK_CAPTURE(cutOne, name##_level, spec, level);                                                    \
    BENCHMARK_CAPTURE(cutOne, name##_sloped, spec, sloped);                                                  \
    BENCHMARK_CAPTURE(cutOne, name##_arc, spec, arc);                                                        \
    BENCHMARK_CAPTURE(cutOne, name##_helix, spec, helix);                                                    \
    BENCHMARK_CAPTURE(cutOne, name##_vertical_arc, spec, verticalArc);                                       \
    BENCHMARK_CAPTURE(cutShort, name##_short, spec)

PROVEOUT_CUT_BENCH(flat, "flat:d=10");
PROVEOUT_CUT_BENCH(ball, "ball:d=10");
PROVEOUT_CUT_BENCH(bull, "bull:d=10,r=2");
PROVEOUT_CUT_BENCH(cone, "cone:d=10,angle=90");
PROVEOUT_CUT_BENCH(taperball, "taperball:d=4,angle=3,h=20");
PROVEOUT_CUT_BENCH(face, "face:d=50,angle=45,h=6,r=0.8");
PROVEOUT_CUT_BENCH(form, "form:p=0/0:3/0:4/1@3/1:6/3@-2:6/8");

} // namespace
} // namespace proveout
