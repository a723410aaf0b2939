// SPDX-License-Identifier: GPL-3.0-or-later
// Finishing programs of growing size for measurements: a ball-end mill moves back and forth over a wavy
// surface.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/cutting/cut/cutting.h"

namespace proveout::bench {

struct Workload {
    const char* name;
    double width; ///< mm, of the stock
    double depth;
    double diameter;
    int lines;   ///< back and forth
    int perLine; ///< motions per line
};
/// From a small mould to a panel die with a million motions.
[[nodiscard]] std::span<const Workload> workloads();

[[nodiscard]] StockBox stockOf(const Workload& workload);
/// Feed motions through and next to the stock; each keeps a pointer to `cutter`.
[[nodiscard]] std::vector<CutterMotion> motionsOf(const Workload& workload, const Cutter& cutter);
/// The same motions as a program for tool 1, one block each after its head.
[[nodiscard]] std::string programOf(const Workload& workload);

} // namespace proveout::bench
