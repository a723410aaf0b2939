// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/product_run.h"

#include <fmt/format.h>
#include <vector>

namespace proveout::bench {

std::string toolOf(const Workload& workload) {
    return fmt::format("ball:d={}", workload.diameter);
}

std::string fileOf(const Workload& workload) {
    return fmt::format("{}.nc", workload.name);
}

MeasuredRun runProduct(const ProductRun& run, const Workload& workload, const std::filesystem::path& folder) {
    std::vector<std::string> words{
        PROVEOUT_CLI,
        "simulate",
        fileOf(workload),
        "--stock",
        fmt::format("{}x{}x40", workload.width, workload.depth),
        "--grid",
        fmt::format("{}", run.spacing),
        "--tool",
        "1=" + toolOf(workload),
        "--threads",
        fmt::format("{}", run.threads),
    };
    if (run.output == Output::solid)
        words.insert(words.end(), {"--stl", "product.stl"});
    else
        words.insert(words.end(), {"--method", "none"});
    if (run.output == Output::records)
        words.emplace_back("--json");
    return runMeasured(words, folder);
}

} // namespace proveout::bench
