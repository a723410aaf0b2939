// SPDX-License-Identifier: GPL-3.0-or-later
// whole_run [RUNS [PART…]]: what the real command line takes for whole programs, beside the sum of the
// kernels that the work consists of, measured in a process of this program and in the same run, and the start
// of the program; how time and memory grow; and what the real window takes for the same, if there is a
// display. PART is a workload, "growth" or "window". Fails if a run takes more than 1.5 times as long as its
// kernels, grows faster than in proportion, or holds up the events of the window.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <oneapi/tbb/global_control.h>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/stop_watch.h"
#include "core/decimation/solid/solid.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/formats/formats.h"
#include "core/formats/solid_export.h"
#include "core/nc/run/interpreter.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/run/simulation.h"
#include "core/simulation/run/walled_moment.h"
#include "tests/bench/bench_folder.h"
#include "tests/bench/growth_table.h"
#include "tests/bench/in_a_process.h"
#include "tests/bench/product_run.h"
#include "tests/bench/window_table.h"
#include "tests/bench/workloads.h"

namespace proveout::bench {
namespace {

constexpr double kMostOfKernels = 1.5;
constexpr double kMegabyte = 1e6;

constexpr const char* kOutputNames[]{"", "records", "STL"};

struct Case {
    std::string_view workload;
    double spacing;
    Output output;
    int threads;
};
constexpr Case kCases[]{
    {"mould", 0.1, Output::solid, 2}, {"mouse", 0.1, Output::none, 2},   {"mouse", 0.1, Output::solid, 2},
    {"die", 0.1, Output::none, 1},    {"die", 0.1, Output::none, 2},     {"die", 0.1, Output::solid, 2},
    {"panel", 1, Output::none, 1},    {"panel", 1, Output::none, 2},     {"panel", 1, Output::solid, 2},
    {"panel", 0.25, Output::none, 2}, {"panel", 0.25, Output::solid, 2}, {"panel", 0.1, Output::none, 1},
    {"panel", 0.1, Output::none, 2},  {"panel", 0.1, Output::solid, 2},  {"die", 0.1, Output::records, 2},
    {"panel", 1, Output::records, 2},
};

/// The seconds of one run of the kernels.
struct Kernels {
    double start = 0; ///< of the program, which then does nothing
    double interpret = 0;
    double records = 0;
    double heights = 0;
    double solid = 0; ///< decimation, closing, measuring and writing

    [[nodiscard]] double sum(Output output) const {
        return start + interpret + (output == Output::records ? records : heights) +
               (output == Output::solid ? solid : 0);
    }
};

double lap(StopWatch& watch) {
    const double seconds = watch.seconds();
    watch = StopWatch();
    return seconds;
}

Kernels runKernels(const Case& one, const Workload& workload, const std::string& text,
                   const std::filesystem::path& folder) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(one.threads));
    Kernels seconds;
    seconds.start = runMeasured({PROVEOUT_CLI, "--version"}, folder).seconds;
    StopWatch watch;
    const auto program = interpret(NcText(text));
    seconds.interpret = lap(watch);

    Setup setup;
    setup.stock = stockOf(workload);
    setup.spacing = one.spacing;
    setup.tools.set(1, parseCutter(toolOf(workload)).value());
    const ToolChoice tools(*program, setup);
    const Grid grid = makeGrid(setup.stock, setup.spacing).value();
    const auto motions = cutterMotions(*program, 0, program->blockCount(), setup, tools);
    lap(watch);
    {
        ZMap zmap = uncutStock(setup.stock, setup.shape, grid).zmap;
        (void)cutHeights(zmap, motions, {});
        seconds.heights = lap(watch);
    }
    ZMap zmap = uncutStock(setup.stock, setup.shape, grid).zmap;
    (void)cut(zmap, motions, {});
    seconds.records = lap(watch);
    if (one.output != Output::solid)
        return seconds;
    const DecimationParameters parameters = forExport({});
    Frame moment;
    moment.program = program;
    moment.setup = std::make_shared<const Setup>(setup);
    moment.block = program->blockCount();
    moment.zmap = zmap.snapshot();
    addWalls(moment, nullptr);
    SurfaceSnapshot surface = decimatedWhole(moment.zmap, parameters);
    SolidForExport solid(
        moment.zmap,
        closeWithWalls(moment.zmap, surface.releaseTriangles(), parameters, CoordinateType::float32)
            .value_or(WalledSolid()),
        errorLevel(parameters), CoordinateType::float32);
    (void)exportSolid(folder / "kernel.stl", *findFormat("stl")->meshWriter(), solid, parameters);
    seconds.solid = lap(watch);
    return seconds;
}

template<class Value, class Order>
const Value& medianOf(std::vector<Value>& values, Order by) {
    std::ranges::sort(values, {}, by);
    return values[values.size() / 2];
}

/// Product and kernels alternate, so that other load on the machine slows both.
bool measure(const Case& one, const Workload& workload, int runs) {
    const BenchFolder folder;
    const std::string text = programOf(workload);
    std::ofstream(folder.path() / fileOf(workload), std::ios::binary) << text;
    std::vector<MeasuredRun> products;
    std::vector<Kernels> kernels;
    for (int run = 0; run < runs; ++run) {
        products.push_back(runProduct({one.spacing, one.output, one.threads}, workload, folder.path()));
        kernels.push_back(inAProcess([&] { return runKernels(one, workload, text, folder.path()); }));
    }
    const MeasuredRun& product = medianOf(products, &MeasuredRun::seconds);
    const Kernels& kernel = medianOf(kernels, [&](const Kernels& k) { return k.sum(one.output); });
    const double ratio = product.seconds / kernel.sum(one.output);
    const bool fine = product.exitCode == 0 && ratio <= kMostOfKernels;
    fmt::print("| {} | {} | {} | {} | {:.2f} | {:.2f} | {:.0f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {} | "
               "{:.2f}{} |\n",
               workload.name, one.spacing, kOutputNames[static_cast<std::size_t>(one.output)], one.threads,
               product.seconds, product.cpuSeconds, product.peakBytes / kMegabyte, kernel.start,
               kernel.interpret, kernel.records, kernel.heights,
               one.output == Output::solid ? fmt::format("{:.2f}", kernel.solid) : "", ratio,
               fine ? "" : " **too slow, or failed**");
    std::fflush(stdout);
    return fine;
}

} // namespace
} // namespace proveout::bench

int main(int argc, char** argv) {
    using namespace proveout::bench;
    const int runs = argc > 1 ? std::stoi(argv[1]) : 5;
    const std::vector<std::string_view> names(argv + std::min(argc, 2), argv + argc);
    const auto isWanted = [&names](std::string_view part) {
        return names.empty() || std::ranges::find(names, part) != names.end();
    };
    fmt::print(
        "| program | grid | | threads | product s | its CPU s | its peak MB | start | interpret | records | "
        "heights | "
        "solid | product / kernels |\n|---|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    bool fine = true;
    for (const Case& one : kCases)
        if (isWanted(one.workload))
            fine = measure(one, *std::ranges::find(workloads(), one.workload, &Workload::name), runs) && fine;
    if (isWanted("growth"))
        fine = printGrowth(workloads().back(), runs) && fine;
    if (isWanted("window"))
        fine = printWindow(runs) && fine;
    return fine ? 0 : 1;
}
