// SPDX-License-Identifier: GPL-3.0-or-later
// A small part of the stock, cut on a much finer grid.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "core/base/work_context.h"
#include "core/decimation/surface/map_memory.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/setup.h"
#include "core/zmap/grid_part.h"

namespace proveout {

/// The box to be shown in detail. Value type.
struct BoxOfInterest {
    PlanBox box;
    double spacing = 0.01; ///< requested grid spacing, mm

    friend bool operator==(const BoxOfInterest&, const BoxOfInterest&) = default;
};

/// The stock within a box after the first `block` blocks.
struct FineMap {
    ZMapSnapshot zmap; ///< of the part alone: its stock is the box, from the top to the floor of the whole
    GridPart part;
    std::size_t block = 0;
    std::size_t motions = 0; ///< number of motions that come near the box, below the top of the stock
    double seconds = 0;      ///< wall time
};

/// The grid over a box. Refuses an invalid box or spacing (makeGridPart()), and one whose maps, with
/// everything made from them, need more than `limitBytes`; the message gives a spacing that would fit.
[[nodiscard]] Result<GridPart> fineGrid(const Setup& setup, const BoxOfInterest& box,
                                        const DecimationParameters& parameters, const MapOutputs& outputs,
                                        double limitBytes);

/// The largest number of bytes that the maps of a box, with everything made from them, need at any one time.
[[nodiscard]] double boxBytes(const GridPart& part, const DecimationParameters& parameters,
                              const MapOutputs& outputs);

/// How a detail region is decimated for the screen and for files: within half of its spacing.
[[nodiscard]] DecimationParameters fineParameters(double spacing);

/// Cuts the first `blocks` blocks within the box; get `part` from fineGrid() first. The heights equal those
/// of a simulation of the whole stock at this spacing at the same points, to the last bit, on any number of
/// threads. Checks every motion (some 50 ns each), and cuts those near the box. Nothing if it was stopped.
/// Any thread.
[[nodiscard]] std::optional<FineMap> cutBox(const Program& program, const Setup& setup, std::size_t blocks,
                                            const GridPart& part, const WorkContext& context = {});

/// Gives a map its rims and walls, after the same blocks of the same program; false if it was stopped. They
/// are those of a simulation of the whole stock at this spacing, but for the outermost two cells, where the
/// points beyond the box are unknown. Any thread.
[[nodiscard]] bool addWalls(FineMap& fine, const std::shared_ptr<const Program>& program,
                            const std::shared_ptr<const Setup>& setup, const WorkContext& context = {});

} // namespace proveout
