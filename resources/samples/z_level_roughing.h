// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "resources/samples/block_budget.h"
#include "resources/samples/height_map.h"
#include "resources/samples/program_writer.h"

namespace proveout::samples {

/// Z-level roughing: on each level zigzag rows along x wherever the cutter fits, then once along each
/// contour.
struct RoughingPlan {
    Vec2 lo{0}; ///< where the axis of the cutter may go
    Vec2 hi{0};
    Vec2 outsideLo{0}; ///< beyond this box the cutter is clear of the stock and may come down in rapid
    Vec2 outsideHi{0};
    double rowSpacing = 5;
    double firstLevel = 0;
    double levelStep = -3;
    int levels = 1;
    double allowance = 0.5; ///< left on the design surface, vertically
    double clearanceZ = 5;
    int cutFeed = 1500;
    int plungeFeed = 400;
};

/// A strip of the level without islands: its rows, each an interval of x.
struct Cell {
    struct Row {
        double y;
        double x0;
        double x1;
    };
    std::vector<Row> rows;
};

/// Cuts the free area of a level into cells, row by row (boustrophedon decomposition).
[[nodiscard]] std::vector<Cell> freeCells(const HeightMap& drop, const RoughingPlan& plan, double level);

/// Appends the whole roughing; its contours take `contourSegments` blocks in all.
void writeRoughing(ProgramWriter& nc, const HeightMap& drop, const RoughingPlan& plan,
                   std::size_t contourSegments);

/// The number of contour segments with which `writeRoughing` takes `blocks` blocks in all, when it goes on
/// from `nc`.
[[nodiscard]] std::size_t contourSegmentsFor(std::size_t blocks, const ProgramWriter& nc,
                                             const HeightMap& drop, const RoughingPlan& plan);

} // namespace proveout::samples
