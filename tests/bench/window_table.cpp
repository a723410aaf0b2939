// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/window_table.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/bench_folder.h"
#include "tests/bench/product_run.h"

namespace proveout::bench {

namespace {

constexpr double kMegabyte = 1e6;
constexpr const char* kJob = "window.proveout";

struct WindowCase {
    std::string_view workload;
    double spacing;
};
constexpr std::array kCases{WindowCase{"mould", 0.1}, WindowCase{"mouse", 0.1}, WindowCase{"die", 0.1},
                            WindowCase{"panel", 1}, WindowCase{"panel", 0.1}};

void writeFiles(const std::filesystem::path& folder, const Workload& workload, double spacing) {
    std::ofstream(folder / fileOf(workload), std::ios::binary) << programOf(workload);
    std::ofstream(folder / kJob) << fmt::format(
        R"({{"proveout":2,"program":"{}","stock":{{"minX":0,"minY":0,"topZ":0,"width":{},"depth":{},"height":40}},)"
        R"("grid":{},"tools":{{"1":"{}"}}}})",
        fileOf(workload), workload.width, workload.depth, spacing, toolOf(workload));
}

MeasuredRun fastest(std::vector<MeasuredRun> runs) {
    return *std::ranges::min_element(runs, {}, &MeasuredRun::seconds);
}

bool printEnd(int runs, const WindowCase& one, const Workload& workload,
              const std::filesystem::path& folder) {
    std::vector<MeasuredRun> windows;
    std::vector<MeasuredRun> products;
    for (int run = 0; run < runs; ++run) {
        windows.push_back(
            runMeasured({PROVEOUT_WINDOW, kJob, "--seek", "end", "--screenshot", "end.png"}, folder));
        products.push_back(runProduct({one.spacing, Output::records, 2}, workload, folder));
    }
    const MeasuredRun window = fastest(windows);
    const MeasuredRun product = fastest(products);
    const bool fine =
        window.exitCode == 0 && product.exitCode == 0 && std::filesystem::exists(folder / "end.png");
    fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.0f} | {:.1f} | {:.1f} |{}\n", workload.name, one.spacing,
               window.seconds, window.cpuSeconds, window.peakBytes / kMegabyte, product.seconds,
               window.seconds - product.seconds, fine ? "" : " **failed**");
    std::fflush(stdout);
    return fine;
}

/// Prints the rows of window_run.
bool printGaps(const WindowCase& one, const Workload& workload, const std::filesystem::path& folder) {
    const MeasuredRun run =
        runMeasured({WINDOW_RUN, fmt::format("{} {}", workload.name, one.spacing), kJob}, folder);
    std::ifstream rows(folder / "out.json");
    fmt::print("{}", std::string(std::istreambuf_iterator<char>(rows), {}));
    std::fflush(stdout);
    return run.exitCode == 0;
}

} // namespace

bool printWindow(int runs) {
    if (std::getenv("DISPLAY") == nullptr) {
        fmt::print("\nThe window is left out: there is no display\n");
        return true;
    }
    bool fine = true;
    const auto forAll = [&fine](const auto& print) {
        for (const WindowCase& one : kCases) {
            const BenchFolder folder;
            const auto workload = std::ranges::find(workloads(), one.workload, &Workload::name);
            writeFiles(folder.path(), *workload, one.spacing);
            fine = print(one, *workload, folder.path()) && fine;
        }
    };
    fmt::print("\n| program | grid | window s | CPU s | peak MB | simulate with records s | beyond it s |\n"
               "|---|--:|--:|--:|--:|--:|--:|\n");
    forAll([runs](const auto&... parts) { return printEnd(runs, parts...); });
    fmt::print("\n| program, grid | the window | s | 99 % of the gaps ms | largest | computed | peak MB | "
               "longest event |\n|---|---|--:|--:|--:|--:|--:|---|\n");
    forAll(printGaps);
    return fine;
}

} // namespace proveout::bench
