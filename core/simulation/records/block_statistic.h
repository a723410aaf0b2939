// SPDX-License-Identifier: GPL-3.0-or-later
// The table of what is known of a block that was executed: one row a statistic. The records of the command
// line have a column for each; the plots read it too. Adding one is a row and the function that reads it.
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

/// What statistics are read from. References must outlive the call they are given to.
struct ExecutedRun {
    const PersistentArray<BlockStatistics>& rows; ///< row k: block k (0-based)
    const Program* program = nullptr;             ///< null: what depends on it is not known
};

/// As precise as it was measured, so that it is written with no more digits than that; empty: not known.
using BlockValue = std::variant<std::monostate, std::uint32_t, float, double>;

/// A plot of one curve. Texts are for people, marked under the context "Plots".
struct StatisticPlot {
    const char* id; ///< stable
    const char* title;
    const char* axis;  ///< with the unit
    const char* curve; ///< its label
    int colour;        ///< row of the colours of curves
};

struct BlockStatistic {
    const char* column; ///< stable: with its unit where it has one, e.g. "maxDepthMm"
    BlockValue (*read)(const ExecutedRun& run, std::size_t block);
    const StatisticPlot* plot = nullptr; ///< null: it has no plot of its own
};

/// All of them, in the order of their columns.
[[nodiscard]] std::span<const BlockStatistic> blockStatistics();
/// By its column; null where there is none.
[[nodiscard]] const BlockStatistic* findStatistic(std::string_view column);

/// NaN where it is not known.
[[nodiscard]] double asNumber(const BlockValue& value);

} // namespace proveout
