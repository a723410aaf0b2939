// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/simulation/run/simulation.h"

namespace proveout {

[[nodiscard]] std::unique_ptr<Simulation> startedSimulation(std::shared_ptr<const Program> program,
                                                            std::shared_ptr<const Setup> setup,
                                                            const DecimationParameters& parameters);

/// Sets other parameters and runs the resulting work.
void apply(Simulation& simulation, const DecimationParameters& parameters, const WorkContext& context = {});
/// Sets an edited program and seeks to the block from which it continues.
void apply(Simulation& simulation, std::shared_ptr<const Program> program);

/// All frames of a direct run, from block 0 to the end.
[[nodiscard]] std::vector<Frame> straightRun(const std::shared_ptr<const Program>& program,
                                             const std::shared_ptr<const Setup>& setup,
                                             const DecimationParameters& parameters);

/// Empty if two frames show the same moment: z-map bit for bit, the same dirty regions, triangles, borders
/// and counts. Otherwise describes the difference.
[[nodiscard]] std::string difference(const Frame& a, const Frame& b);

/// All values of a row except times.
[[nodiscard]] inline auto outcome(const BlockStatistics& row) {
    return std::make_tuple(row.facesShown, row.facesFull, row.regionsDirty, row.regionsDecimated,
                           row.maxDepth, row.radialEngagement, row.removedMm3);
}

[[nodiscard]] bool sameZMap(const ZMapSnapshot& a, const ZMapSnapshot& b);

} // namespace proveout
