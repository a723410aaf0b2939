// SPDX-License-Identifier: GPL-3.0-or-later
// memory_table [PROVEOUT-CLI]: compares the peak memory of some sixty runs with their forecasts. Exits with 1
// if a run uses more than 1.2 times its forecast, is refused, or is killed.
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <string>

#include "tests/app/memory_cases.h"
#include "tests/bench/bench_folder.h"

namespace {

constexpr double kMegabyte = 1e6;

} // namespace

int main(int argc, char** argv) {
    using namespace proveout;
    const std::filesystem::path program = std::filesystem::absolute(argc > 1 ? argv[1] : PROVEOUT_CLI);
    const bench::BenchFolder folder;
    writeMemoryInputs(folder.path());
    const double smallest = smallestPeakBytes(program, folder.path());
    fmt::print("a small map: {:.0f} MB, which the peaks are without\n\n", smallest / kMegabyte);
    fmt::print("| forecast MB | peak MB | peak / forecast | s | run | |\n|--:|--:|--:|--:|:--|:--|\n");
    int broken = 0;
    for (const MemoryCase& one : memoryCases()) {
        const MemoryRun run = runForMemory(program, folder.path(), one.arguments);
        const double peak = run.peakBytes - smallest;
        const std::string why = brokenPromise(run, smallest);
        fmt::print("| {:.0f} | {:.0f} | {:.2f} | {:.1f} | {} | {} |\n", run.forecastBytes / kMegabyte,
                   peak / kMegabyte, run.forecastBytes > 0 ? peak / run.forecastBytes : 0, run.seconds,
                   one.arguments, why);
        std::fflush(stdout);
        broken += why.empty() ? 0 : 1;
    }
    fmt::print("\n{} runs, {} beyond their forecast, refused or killed\n", memoryCases().size(), broken);
    return broken == 0 ? 0 : 1;
}
