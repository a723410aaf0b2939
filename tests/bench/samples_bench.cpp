// SPDX-License-Identifier: GPL-3.0-or-later
// Both samples from start to end, and the operations that a user waits for: seeks, steps backwards, a change
// of the allowance. Argument: the decimation period; 0 means cutting only.
#include <algorithm>
#include <benchmark/benchmark.h>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/base/stop_watch.h"
#include "core/formats/job_file.h"
#include "core/nc/run/interpreter.h"
#include "core/simulation/run/simulation.h"

namespace proveout {
namespace {

constexpr const char* kMouse = "mouse-case";
constexpr const char* kInsert = "core-insert";

struct Sample {
    Job job;
    NcText text;
    std::shared_ptr<const Program> program;

    explicit Sample(const std::string& name)
        : job(readJob(std::string(PROVEOUT_SOURCE_DIR) + "/resources/samples/" + name + ".proveout").value()),
          text(NcText::load(job.program).value()), program(interpret(text)) {}

    [[nodiscard]] std::unique_ptr<Simulation> start(int period, double spacing) const {
        auto setup = std::make_shared<Setup>(job.setup);
        setup->spacing = spacing;
        DecimationParameters parameters = job.parameters;
        parameters.period = period;
        return std::move(Simulation::create(program, std::move(setup), parameters).value());
    }
};

/// The whole run, including interpretation; with `everyBlock` a frame is created at every block (paper mode
/// without drawing).
void runSample(benchmark::State& state, const char* name, double spacing, bool everyBlock) {
    const Sample sample(name);
    double cut = 0;
    double decimate = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(interpret(sample.text));
        const auto simulation = sample.start(static_cast<int>(state.range(0)), spacing);
        while (everyBlock && !simulation->atEnd()) {
            simulation->step();
            benchmark::DoNotOptimize(simulation->frame());
        }
        simulation->seek(simulation->blockCount());
        cut += simulation->effort().cutSeconds;
        decimate += simulation->effort().decimationSeconds;
    }
    state.counters["cut_s"] = benchmark::Counter(cut, benchmark::Counter::kAvgIterations);
    state.counters["decimate_s"] = benchmark::Counter(decimate, benchmark::Counter::kAvgIterations);
    state.counters["blocks/s"] = benchmark::Counter(static_cast<double>(sample.program->blockCount()),
                                                    benchmark::Counter::kIsIterationInvariantRate);
}

/// Seeks to random blocks of a program that has been run.
void seekSample(benchmark::State& state, const char* name, double spacing) {
    const Sample sample(name);
    const auto simulation = sample.start(static_cast<int>(state.range(0)), spacing);
    simulation->seek(simulation->blockCount());
    std::mt19937 random(1);
    std::vector<double> milliseconds;
    for (auto _ : state) {
        const StopWatch watch;
        simulation->seek(random() % (simulation->blockCount() + 1));
        milliseconds.push_back(1000 * watch.seconds());
    }
    std::ranges::sort(milliseconds);
    state.counters["99th_ms"] = milliseconds[milliseconds.size() * 99 / 100];
    state.counters["largest_ms"] = milliseconds.back();
}

/// Steps backwards from the end, one block at a time.
void stepBack(benchmark::State& state, const char* name) {
    const Sample sample(name);
    const auto simulation = sample.start(static_cast<int>(state.range(0)), 1);
    simulation->seek(simulation->blockCount());
    for (auto _ : state)
        simulation->seek(simulation->position() == 0 ? simulation->blockCount() : simulation->position() - 1);
}

/// Changes the allowance at the end of the program.
void tune(benchmark::State& state, const char* name) {
    const Sample sample(name);
    const auto simulation = sample.start(static_cast<int>(state.range(0)), 1);
    simulation->seek(simulation->blockCount());
    DecimationParameters parameters = simulation->frame().parameters;
    for (auto _ : state) {
        parameters.allowance = parameters.allowance > 0.07 ? 0.05 : 0.1;
        simulation->noteParameters(parameters);
        simulation->seek(simulation->position());
    }
}

BENCHMARK_CAPTURE(runSample, insert_1mm, kInsert, 1.0, false)->Arg(0)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(runSample, mouse_1mm, kMouse, 1.0, false)->Arg(0)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(runSample, mouse_1mm_every_block, kMouse, 1.0, true)
    ->Arg(0)
    ->Arg(20)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(runSample, mouse_0_1mm, kMouse, 0.1, false)->Arg(0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(seekSample, insert, kInsert, 1.0)->Arg(20)->Arg(-1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(seekSample, mouse, kMouse, 1.0)->Arg(20)->Arg(-1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(seekSample, mouse_0_1mm, kMouse, 0.1)
    ->Arg(20)
    ->Arg(0)
    ->Unit(benchmark::kMillisecond)
    ->MinTime(5);
BENCHMARK_CAPTURE(stepBack, mouse, kMouse)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tune, mouse, kMouse)->Arg(20)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace proveout
