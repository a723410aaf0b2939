// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/simulation/run/simulation.h"

namespace proveout {

[[nodiscard]] std::unique_ptr<Simulation> startedSimulation(std::shared_ptr<const Program> program,
                                                            std::shared_ptr<const Setup> setup,
                                                            const DecimationParameters& parameters);

/// Notes other parameters and does the work for them.
void apply(Simulation& simulation, const DecimationParameters& parameters, const WorkContext& context = {});
/// Notes an edited program and goes to the block where it goes on.
void apply(Simulation& simulation, std::shared_ptr<const Program> program);

/// All frames of a straight run, from block 0 to the end.
[[nodiscard]] std::vector<Frame> straightRun(const std::shared_ptr<const Program>& program,
                                             const std::shared_ptr<const Setup>& setup,
                                             const DecimationParameters& parameters);

/// Empty where two frames show the same moment: z-map bit for bit, the same dirty regions, the same triangles
/// and borders, the same counts. Else what differs.
[[nodiscard]] std::string difference(const Frame& a, const Frame& b);

[[nodiscard]] bool sameZMap(const ZMapSnapshot& a, const ZMapSnapshot& b);

} // namespace proveout
