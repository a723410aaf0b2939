// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/workloads.h"

namespace proveout::bench {

/// Prints how time and memory of the command line grow with the blocks of a program and with the points of
/// its grid: as exponents, 1 for a growth in proportion. False if a run fails or grows faster than that.
[[nodiscard]] bool printGrowth(const Workload& workload, int runs);

} // namespace proveout::bench
