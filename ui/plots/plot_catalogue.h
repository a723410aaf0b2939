// SPDX-License-Identifier: GPL-3.0-or-later
// The table of plots: one row per plot, used by the panel, export and tests. A block statistic with a plot of
// its own (core/simulation/records/block_statistic.h) is included without a row here.
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

/// The data that plots are drawn from. References must stay valid during the call that uses them.
struct PlotInput {
    const PersistentArray<BlockStatistics>& blocks; ///< row k: block k + 1
    const std::vector<FrameStatistics>& frames;
    const MachineTimes* times = nullptr; ///< for the program of the blocks; null: not known yet
    const Program* program = nullptr;    ///< of the blocks; null: values that depend on it are unknown
};

/// One curve. Curves also differ by dash pattern or fill, never by colour alone.
struct PlotSeries {
    const char* key;   ///< column in a CSV file
    const char* label; ///< the name that is shown; marked in the context "Plots"
    int colour;        ///< index for seriesColour()
    Qt::PenStyle pen;
    Qt::BrushStyle fill; ///< down to the axis, or to the curve below it if stacked
};

/// The blocks (first, last] of one frame.
struct PictureBlocks {
    std::uint32_t first = 0;
    std::uint32_t last = 0; ///< equal to `first`: no frame is known
};

/// One plot over the blocks; row k belongs to block k + 1.
struct PlotSpec {
    const char* id;    ///< stable
    const char* title; ///< marked in the context "Plots", like the labels
    const char* xLabel;
    const char* yLabel; ///< with the unit
    bool stacked;       ///< curves are stacked in the sequence of `series`
    bool timed;         ///< values change with PlotInput::times
    bool wide;          ///< uses a logarithmic axis if its values differ too much for a linear one
    std::span<const PlotSeries> series;
    std::function<double(const PlotInput&, std::size_t row, std::size_t series)>
        y; ///< value of the curve itself, not of the stack; NaN: unknown
    /// Null unless some curves are measured per frame; a row then shows its share, the mean per block.
    PictureBlocks (*picture)(const PlotInput&, std::size_t row) = nullptr;
    bool measured = false; ///< values that are known only of blocks that were played
};

[[nodiscard]] std::span<const PlotSpec> plotCatalogue();

} // namespace proveout
