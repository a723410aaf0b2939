// SPDX-License-Identifier: GPL-3.0-or-later
// The table of plots: one row a plot. Panel, export and tests read it. A statistic of blocks with a plot of
// its own (core/simulation/records/block_statistic.h) is in it without a row here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <Qt>

#include "core/base/persistent_array.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/time/machine_time.h"

namespace proveout {

/// What plots are drawn from. References must outlive the call they are given to.
struct PlotInput {
    const PersistentArray<BlockStatistics>& blocks; ///< row k: block k + 1
    const std::vector<FrameStatistics>& frames;
    const MachineTimes* times = nullptr; ///< of the blocks' program; null: not known yet
    const Program* program = nullptr;    ///< of the blocks; null: what depends on it is not known
};

/// One curve. Curves differ by dash or filling too, never by colour alone.
struct PlotSeries {
    const char* key;   ///< column in a CSV file
    const char* label; ///< for people; marked under the context "Plots"
    int colour;        ///< row of seriesColour()
    Qt::PenStyle pen;
    Qt::BrushStyle fill; ///< down to the axis, or to the curve before it in a stack
};

/// The blocks (first, last] of one picture.
struct PictureBlocks {
    std::uint32_t first = 0;
    std::uint32_t last = 0; ///< equal to `first`: no picture is known
};

/// One plot over the blocks; row k is of block k + 1.
struct PlotSpec {
    const char* id;    ///< stable
    const char* title; ///< marked under the context "Plots", like the labels
    const char* xLabel;
    const char* yLabel; ///< with the unit
    bool stacked;       ///< curves stand on each other, in the order of `series`
    bool timed;         ///< values change with PlotInput::times
    bool wide;          ///< on a logarithmic axis where its values differ too much for an even one
    std::span<const PlotSeries> series;
    std::function<double(const PlotInput&, std::size_t row, std::size_t series)>
        y; ///< of the curve itself, not of the stack; NaN: not known
    /// Null unless some curves were measured by picture; a row then has its share, the mean of a block.
    PictureBlocks (*picture)(const PlotInput&, std::size_t row) = nullptr;
};

[[nodiscard]] std::span<const PlotSpec> plotCatalogue();

} // namespace proveout
