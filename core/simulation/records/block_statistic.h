// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the known values of an executed block: one row per statistic. The records of the command line
// have a column for each; the plots read the table too. Adding a statistic takes a row and the function that
// reads it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

#include "core/base/persistent_array.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/statistics.h"

namespace proveout {

/// The data from which statistics are computed. References must outlive the call they are passed to.
struct ExecutedRun {
    const PersistentArray<BlockStatistics>& rows; ///< row k: block k (0-based)
    const Program* program = nullptr;             ///< null: values that depend on it are unknown
};

/// In the precision of the measurement, so that it is written with no more digits than that; empty: unknown.
using BlockValue = std::variant<std::monostate, std::uint32_t, float, double>;

/// A plot of one curve. Texts are for the user interface, marked under the context "Plots".
struct StatisticPlot {
    const char* id; ///< stable
    const char* title;
    const char* axis;  ///< with the unit
    const char* curve; ///< its label
    int colour;        ///< row of the colours of curves
};

struct BlockStatistic {
    const char* column; ///< stable: with its unit if it has one, e.g. "maxDepthMm"
    BlockValue (*read)(const ExecutedRun& run, std::size_t block);
    const StatisticPlot* plot = nullptr; ///< null: it has no plot of its own
};

/// All statistics, in the order of their columns.
[[nodiscard]] std::span<const BlockStatistic> blockStatistics();
/// The statistic of a column; null if there is none.
[[nodiscard]] const BlockStatistic* findStatistic(std::string_view column);

/// NaN if the value is unknown.
[[nodiscard]] double asNumber(const BlockValue& value);

} // namespace proveout
