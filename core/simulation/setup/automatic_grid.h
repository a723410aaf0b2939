// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of a setup that does not name one: as fine as its cutters need, as coarse as the machine needs.
#pragma once

#include <optional>

#include "core/base/diagnostic.h"
#include "core/decimation/surface/map_memory.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

/// The allowed number of points of an automatic grid.
struct GridLimits {
    double fewest = 1e6; ///< for a smooth picture, unless that needs a spacing below 0.01 mm
    double most = 4e6;
};

/// The limits of this computer: at most a million points per core, and what fits half of the memory that may
/// be used (memoryLimitBytes()) and the decimation method. Rounded, because free memory changes all the time.
[[nodiscard]] GridLimits gridLimits(const DecimationParameters& parameters,
                                    const MapOutputs& outputs = {.whole = true});

/// A tool of a program with the diameter of its cutter, mm.
struct CutterInUse {
    int tool = 0;
    double diameter = 0;
};

/// The smallest cutter that the program uses at feed; nothing if none of its tools has a cutter.
[[nodiscard]] std::optional<CutterInUse> smallestCutter(const Program& program, const Setup& setup,
                                                        const ToolChoice& tools);

/// A tenth of the smallest diameter, if it is known, within the limits: never more than `most` points, and at
/// least `fewest`, but not finer than 0.01 mm for the sake of `fewest`, and never finer than 0.001 mm, which
/// is the accuracy of the cuts. Two digits; makeGrid() accepts it for any stock that it accepts.
[[nodiscard]] double automaticSpacing(const StockBox& stock, const std::optional<CutterInUse>& smallest,
                                      const GridLimits& limits);

/// The spacing of `setup`: the given one, or, for an automatic grid, the one on which nothing of a saved
/// stock is lost, otherwise automaticSpacing().
[[nodiscard]] double gridSpacing(const Setup& setup, const Program& program, const GridLimits& limits);

/// A warning if the grid has fewer than five points across the smallest cutter. `automatic`: the spacing was
/// not chosen by the user; it is as fine as the limits permit.
[[nodiscard]] Diagnostics coarseGrid(const Grid& grid, const std::optional<CutterInUse>& smallest,
                                     bool automatic);

} // namespace proveout
