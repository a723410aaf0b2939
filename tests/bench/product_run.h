// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the real command line with a workload, in a process of its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "tests/app/measured_run.h"
#include "tests/bench/workloads.h"

namespace proveout::bench {

/// What a run does: cut for the heights alone, record every block as well, or write the solid as STL.
enum class Output : std::uint8_t { none, records, solid };

struct ProductRun {
    double spacing = 1; ///< mm
    Output output = Output::none;
    int threads = 2;
};

/// The tool of all workloads, as an option of the command line.
[[nodiscard]] std::string toolOf(const Workload& workload);

/// The name of the program of a workload.
[[nodiscard]] std::string fileOf(const Workload& workload);

/// `proveout-cli simulate` in a folder that has the program of the workload.
[[nodiscard]] MeasuredRun runProduct(const ProductRun& run, const Workload& workload,
                                     const std::filesystem::path& folder);

} // namespace proveout::bench
