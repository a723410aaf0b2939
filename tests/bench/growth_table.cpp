// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/growth_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <vector>

#include "tests/bench/bench_folder.h"
#include "tests/bench/product_run.h"

namespace proveout::bench {

namespace {

constexpr double kMegabyte = 1e6;
constexpr double kMostExponent = 1.15; ///< in proportion, and what other load on the machine adds
constexpr std::array kShares{4, 2, 1}; ///< the blocks of a line are divided by these
constexpr double kSpacingOfBlocks = 0.4;
constexpr std::array kSpacings{0.4, 0.2, 0.1};
constexpr std::array kOutputs{Output::none, Output::solid};

struct Size {
    double amount = 0; ///< of what grows
    MeasuredRun run;
};

/// The fastest of several runs, because other load only adds.
MeasuredRun fastest(const ProductRun& run, const Workload& workload, int runs) {
    const BenchFolder folder;
    std::ofstream(folder.path() / fileOf(workload), std::ios::binary) << programOf(workload);
    std::vector<MeasuredRun> all;
    for (int k = 0; k < runs; ++k)
        all.push_back(runProduct(run, workload, folder.path()));
    return *std::ranges::min_element(all, {}, &MeasuredRun::cpuSeconds);
}

double exponent(double before, double after, const Size& smaller, const Size& larger) {
    return std::log(after / before) / std::log(larger.amount / smaller.amount);
}

bool printRow(const char* grows, Output output, const Size* before, const Size& size) {
    const auto exponentOf = [&](double MeasuredRun::*figure) {
        return before == nullptr ? 0 : exponent(before->run.*figure, size.run.*figure, *before, size);
    };
    const double time = exponentOf(&MeasuredRun::cpuSeconds);
    const double memory = exponentOf(&MeasuredRun::peakBytes);
    const bool fine = size.run.exitCode == 0 && std::max(time, memory) <= kMostExponent;
    const auto shown = [&](double value) {
        return before == nullptr ? std::string() : fmt::format("{:.2f}", value);
    };
    fmt::print("| {} | {} | {:.3g} M | {:.2f} | {:.2f} | {:.0f} | {} | {}{} |\n", grows,
               output == Output::solid ? "STL" : "", size.amount / 1e6, size.run.seconds, size.run.cpuSeconds,
               size.run.peakBytes / kMegabyte, shown(time), shown(memory),
               fine ? "" : " **faster than in proportion, or failed**");
    std::fflush(stdout);
    return fine;
}

bool printBlocks(const Workload& workload, Output output, int runs) {
    bool fine = true;
    std::optional<Size> before;
    for (const int share : kShares) {
        Workload part = workload;
        part.perLine /= share;
        const Size size{static_cast<double>(part.lines) * part.perLine,
                        fastest({kSpacingOfBlocks, output}, part, runs)};
        fine = printRow("blocks", output, before ? &*before : nullptr, size) && fine;
        before = size;
    }
    return fine;
}

bool printPoints(const Workload& workload, Output output, int runs) {
    bool fine = true;
    std::optional<Size> before;
    for (const double spacing : kSpacings) {
        const Size size{workload.width * workload.depth / (spacing * spacing),
                        fastest({spacing, output}, workload, runs)};
        fine = printRow("points", output, before ? &*before : nullptr, size) && fine;
        before = size;
    }
    return fine;
}

} // namespace

bool printGrowth(const Workload& workload, int runs) {
    fmt::print("\n| what grows | | of it | s | CPU s | peak MB | exponent of CPU s | of memory |\n"
               "|---|---|--:|--:|--:|--:|--:|--:|\n");
    bool fine = true;
    for (const Output output : kOutputs) {
        fine = printBlocks(workload, output, runs) && fine;
        fine = printPoints(workload, output, runs) && fine;
    }
    return fine;
}

} // namespace proveout::bench
