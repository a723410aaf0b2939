// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of a setup that names none: as fine as its cutters need, as coarse as the machine needs.
#pragma once

#include <optional>

#include "core/base/diagnostic.h"
#include "core/decimation/surface/map_memory.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

/// How many points an automatic grid may have.
struct GridLimits {
    double fewest = 1e6; ///< for a smooth picture, unless it takes a spacing below 0.01 mm
    double most = 4e6;
};

/// Those of this computer: at most a million points a core, and what half of the memory that may be taken
/// (memoryLimitBytes()) and the decimation method hold. Rounded, because free memory changes all the time.
[[nodiscard]] GridLimits gridLimits(const DecimationParameters& parameters,
                                    const MapOutputs& outputs = {.whole = true});

/// A tool of a program with the diameter of its cutter, mm.
struct CutterInUse {
    int tool = 0;
    double diameter = 0;
};

/// The smallest cutter that the program uses at feed; nothing where none of its tools has a cutter.
[[nodiscard]] std::optional<CutterInUse> smallestCutter(const Program& program, const Setup& setup,
                                                        const ToolChoice& tools);

/// A tenth of the smallest diameter, where it is known, within the limits: never more than `most` points, and
/// `fewest` at least, but for these no finer than 0.01 mm, and in no case finer than 0.001 mm, which is how
/// exact the cuts are. Two digits; makeGrid() takes it for any stock that it takes.
[[nodiscard]] double automaticSpacing(const StockBox& stock, const std::optional<CutterInUse>& smallest,
                                      const GridLimits& limits);

/// The spacing that `setup` has: the given one, or, of an automatic grid, that on which nothing of a saved
/// stock is lost, else automaticSpacing().
[[nodiscard]] double gridSpacing(const Setup& setup, const Program& program, const GridLimits& limits);

/// A warning where the grid has fewer than five points across the smallest cutter.
/// `automatic`: nobody has chosen the spacing; it is as fine as the limits are.
[[nodiscard]] Diagnostics coarseGrid(const Grid& grid, const std::optional<CutterInUse>& smallest,
                                     bool automatic);

} // namespace proveout
