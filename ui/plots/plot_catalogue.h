// SPDX-License-Identifier: GPL-3.0-or-later
// The table of plots: one row a plot. Panel, export and tests read it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Qt>

#include "core/base/persistent_array.h"
#include "core/simulation/machine_time.h"
#include "core/simulation/statistics.h"

namespace proveout {

/// What plots are drawn from. References must outlive the call they are given to.
struct PlotInput {
    const PersistentArray<BlockStatistics>& blocks; ///< row k: block k + 1
    const std::vector<FrameStatistics>& frames;
    const MachineTimes* times = nullptr; ///< of the blocks' program; null: not known yet
};

/// One curve. Curves differ by dash or filling too, never by colour alone.
struct PlotSeries {
    const char* key;   ///< column in a CSV file
    const char* label; ///< for people; marked under the context "Plots"
    int colour;        ///< row of seriesColour()
    Qt::PenStyle pen;
    Qt::BrushStyle fill; ///< down to the axis, or to the curve before it in a stack
};

/// A row of blocks is a point; one of frames is a step over the blocks that its picture stands for, as high
/// as their mean: what lies under it is what was spent.
enum class PlotRows : std::uint8_t { blocks, frames };

/// One plot over the blocks.
struct PlotSpec {
    const char* id;    ///< stable
    const char* title; ///< marked under the context "Plots", like the labels
    const char* xLabel;
    const char* yLabel; ///< with the unit
    PlotRows rows;
    bool stacked; ///< curves stand on each other, in the order of `series`
    bool timed;   ///< values change with PlotInput::times
    std::span<const PlotSeries> series;
    double (*begin)(const PlotInput&, std::size_t row); ///< a row stands for the blocks (begin, x]
    double (*x)(const PlotInput&, std::size_t row);
    double (*y)(const PlotInput&, std::size_t row,
                std::size_t series); ///< of the curve itself, not of the stack; NaN: not known
};

[[nodiscard]] std::span<const PlotSpec> plotCatalogue();

[[nodiscard]] std::size_t rowCount(const PlotSpec& plot, const PlotInput& input);

} // namespace proveout
