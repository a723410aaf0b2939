// SPDX-License-Identifier: GPL-3.0-or-later
// What rims cost a run of the command line: in pairs with `--rims off`, one after the other, so that other
// load on the machine slows both. `rims_table [PAIRS]` prints a table in Markdown.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/app/measured_run.h"
#include "tests/bench/bench_folder.h"
#include "tests/bench/product_run.h"
#include "tests/bench/workloads.h"

namespace proveout::bench {
namespace {

/// A program, and the options of its stock and tool.
struct Job {
    std::string name;
    std::string program;
    std::string stock;
    std::string tool;
};

Job finishing(std::string_view name) {
    const Workload& workload = *std::ranges::find(workloads(), name, &Workload::name);
    return {std::string(name), programOf(workload), fmt::format("{}x{}x40", workload.width, workload.depth),
            "1=" + toolOf(workload)};
}

/// A plate with round pockets, slots and a contour, in steps down of 2 mm, cut with a flat end mill of 6 mm.
Job plate() {
    std::string text = "T1 M6\nS12000 M3\nG0 Z5\nF2000\n";
    const auto add = [&]<class... Values>(fmt::format_string<Values...> format, Values&&... values) {
        text += fmt::format(format, std::forward<Values>(values)...);
    };
    for (int k = 0; k < 24; ++k) {
        const double x = 40.3 + 40 * (k % 6);
        const double y = 40.7 + 40 * (k / 6);
        for (int step = 1; step <= 5; ++step) {
            add("G0 X{:.3f} Y{:.3f} Z5\nG1 Z{} F500\nF2000\n", x + 1, y, -2 * step);
            for (double radius = 1; radius < 12; radius += 2.5)
                add("G1 X{:.3f}\nG3 I{:.3f} J0\n", x + radius, -radius);
            add("G0 Z5\n");
        }
    }
    for (int k = 0; k < 6; ++k) {
        for (int step = 1; step <= 4; ++step)
            add("G0 X{:.3f} Y205.3 Z5\nG1 Z{} F500\nF2000\nX{:.3f} Y{:.3f}\nG0 Z5\n", 25.0 + 40 * k,
                -2 * step, 50.0 + 40 * k, 220.0 + 2 * k);
    }
    for (int step = 1; step <= 5; ++step)
        add("G0 X4 Y4 Z5\nG1 Z{} F500\nF2000\nX276\nG3 X296 Y24 J20\nG1 Y226\nG3 X276 Y246 I-20\nG1 X4\nY4\n"
            "G0 Z5\n",
            -3 * step);
    return {"plate", text + "M30\n", "300x250x20", "1=flat:d=6"};
}

struct Pair {
    MeasuredRun on;
    MeasuredRun off;

    [[nodiscard]] double ratio() const { return on.seconds / off.seconds; }
};

MeasuredRun runOnce(const Job& job, double spacing, bool writes, const char* rims,
                    const BenchFolder& folder) {
    std::vector<std::string> words{PROVEOUT_CLI,
                                   "simulate",
                                   job.name + ".nc",
                                   "--stock",
                                   job.stock,
                                   "--grid",
                                   fmt::format("{}", spacing),
                                   "--tool",
                                   job.tool,
                                   "--allow-outside",
                                   "--rims",
                                   rims};
    if (writes)
        words.insert(words.end(), {"--stl", "out.stl"});
    return runMeasured(words, folder.path());
}

void printRow(const Job& job, double spacing, bool writes, int pairs) {
    const BenchFolder folder;
    std::ofstream(folder.path() / (job.name + ".nc"), std::ios::binary) << job.program;
    std::vector<Pair> all;
    for (int k = 0; k < pairs; ++k)
        all.push_back(
            {runOnce(job, spacing, writes, "on", folder), runOnce(job, spacing, writes, "off", folder)});
    std::ranges::sort(all, {}, &Pair::ratio);
    const Pair& middle = all[all.size() / 2];
    fmt::print("| {} | {} | {} | {:.3f} | {:.3f} | {:.2f} | {:.2f} | {:.0f} | {:.0f} |\n", job.name, spacing,
               writes ? "STL" : "", middle.off.seconds, middle.on.seconds, middle.ratio(), all.back().ratio(),
               middle.off.peakBytes / 1e6, middle.on.peakBytes / 1e6);
    std::fflush(stdout);
}

int run(int pairs) {
    fmt::print("| program | spacing | | s, off | s, on | on / off | largest | peak MB, off | peak MB, on |\n"
               "|---|--:|---|--:|--:|--:|--:|--:|--:|\n");
    const std::vector<std::pair<Job, double>> rows{
        {finishing("die"), 0.1}, {finishing("panel"), 1}, {finishing("panel"), 0.1},
        {plate(), 0.5},          {plate(), 0.2},          {plate(), 0.1}};
    for (const bool writes : {false, true}) {
        for (const auto& [job, spacing] : rows)
            printRow(job, spacing, writes, pairs);
    }
    return 0;
}

} // namespace
} // namespace proveout::bench

int main(int count, char** words) {
    int pairs = 5;
    if (count > 1) {
        const std::string_view word(words[1]);
        std::from_chars(word.data(), word.data() + word.size(), pairs);
    }
    return proveout::bench::run(std::max(pairs, 1));
}
