// SPDX-License-Identifier: GPL-3.0-or-later
// NC text to motions: the other interpreter beside ours (interpreter_comparison.h), then million lines per
// second by kind of program, and how long the text itself takes. `--benchmark_filter=none`: the first alone.
#include <benchmark/benchmark.h>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <sstream>
#include <string>

#include "core/formats/nc_motion.h"
#include "core/nc/run/interpreter.h"
#include "tests/bench/interpreter_comparison.h"

namespace {

using namespace proveout;

constexpr int kLines = 1'000'000;

/// A finishing pass as a CAM system writes it: coordinates with three decimals.
std::string straightLines() {
    std::string text = "G21 G90 G17\nT1 M6\nS8000 M3\nG0 X0 Y0 Z5\nG1 Z0 F1200\n";
    for (int i = 0; i < kLines; ++i) {
        const double t = i * 1e-3;
        fmt::format_to(std::back_inserter(text), "X{:.3f} Y{:.3f} Z{:.3f}\n", 100 * std::sin(t),
                       100 * std::cos(t), -5 + std::sin(7 * t));
    }
    return text + "M30\n";
}

std::string arcs() {
    std::string text = "G21 G90 G17 F500\nG0 X10 Y0 Z0\n";
    for (int i = 0; i < kLines / 2; ++i)
        text += "N100 G2 X0.000 Y-10.000 I-10.000 J0.000\nN110 G3 X10.000 Y0.000 R10.000 F600\n";
    return text + "M30\n";
}

void interpretText(benchmark::State& state, const NcText& text) {
    for (auto run : state)
        benchmark::DoNotOptimize(interpret(text));
    state.counters["lines/s"] = benchmark::Counter(static_cast<double>(text.lineCount()),
                                                   benchmark::Counter::kIsIterationInvariantRate);
}

void interpretStraight(benchmark::State& state) {
    interpretText(state, NcText(straightLines()));
}

void interpretArcs(benchmark::State& state) {
    interpretText(state, NcText(arcs()));
}

void splitIntoLines(benchmark::State& state) {
    const std::string bytes = straightLines();
    for (auto run : state)
        benchmark::DoNotOptimize(NcText(bytes));
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes.size()) * state.iterations());
}

void typeOneCharacter(benchmark::State& state) {
    NcText text(straightLines());
    std::size_t offset = text.size() / 2;
    for (auto run : state)
        text = text.replaced(offset++, 0, "1");
}

void writeRecords(benchmark::State& state) {
    const NcText text(straightLines());
    const auto program = interpret(text);
    for (auto run : state) {
        std::ostringstream out;
        writeNcMotion(out, *program, text, {"bench", "bench.ngc", false, {}});
        benchmark::DoNotOptimize(out);
    }
    state.counters["records/s"] = benchmark::Counter(static_cast<double>(program->motionCount()),
                                                     benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(interpretStraight)->Unit(benchmark::kMillisecond);
BENCHMARK(interpretArcs)->Unit(benchmark::kMillisecond);
BENCHMARK(splitIntoLines)->Unit(benchmark::kMillisecond);
BENCHMARK(typeOneCharacter)->Unit(benchmark::kMicrosecond);
BENCHMARK(writeRecords)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv) {
    const bool good = proveout::bench::compareInterpreters();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return good ? 0 : 1;
}
