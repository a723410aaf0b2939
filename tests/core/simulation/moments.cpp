// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/simulation/moments.h"

#include <cstring>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <utility>

namespace proveout {

std::unique_ptr<Simulation> startedSimulation(std::shared_ptr<const Program> program,
                                              std::shared_ptr<const Setup> setup,
                                              const DecimationParameters& parameters) {
    auto created = Simulation::create(std::move(program), std::move(setup), parameters);
    EXPECT_TRUE(created) << message(created.error().front());
    return std::move(created.value());
}

void apply(Simulation& simulation, const DecimationParameters& parameters, const WorkContext& context) {
    simulation.noteParameters(parameters);
    simulation.seek(simulation.position(), context);
}

void apply(Simulation& simulation, std::shared_ptr<const Program> program) {
    simulation.seek(simulation.noteProgram(std::move(program)));
}

std::vector<Frame> straightRun(const std::shared_ptr<const Program>& program,
                               const std::shared_ptr<const Setup>& setup,
                               const DecimationParameters& parameters) {
    const auto simulation = startedSimulation(program, setup, parameters);
    std::vector<Frame> frames{simulation->frame()};
    while (!simulation->atEnd()) {
        simulation->step();
        frames.push_back(simulation->frame());
    }
    return frames;
}

bool sameZMap(const ZMapSnapshot& a, const ZMapSnapshot& b) {
    if (!(a.grid() == b.grid()))
        return false;
    for (std::size_t tile = 0; tile < a.tileCount(); ++tile)
        if (std::memcmp(a.tile(tile)->heights.data(), b.tile(tile)->heights.data(),
                        sizeof(a.tile(tile)->heights)) != 0)
            return false;
    return true;
}

std::string difference(const Frame& a, const Frame& b) {
    if (a.block != b.block)
        return fmt::format("block {} / {}", a.block, b.block);
    if (!sameZMap(a.zmap, b.zmap))
        return "heights";
    if (a.removedMm3 != b.removedMm3)
        return fmt::format("removed {} / {}", a.removedMm3, b.removedMm3);
    if (a.surface.dirtyRegions != b.surface.dirtyRegions)
        return fmt::format("dirty {} / {}", a.surface.dirtyRegions, b.surface.dirtyRegions);
    if (a.surface.faces != b.surface.faces)
        return fmt::format("faces {} / {}", a.surface.faces, b.surface.faces);
    for (std::size_t region = 0; region < a.surface.meshes.size(); ++region) {
        const auto& first = a.surface.meshes[region];
        const auto& second = b.surface.meshes[region];
        if ((first == nullptr) != (second == nullptr))
            return fmt::format("region {} is dirty in one", region);
        if (first && first->triangles != second->triangles)
            return fmt::format("triangles of region {}", region);
    }
    for (std::size_t border = 0; border < a.surface.borders.size(); ++border) {
        const auto& first = a.surface.borders[border];
        const auto& second = b.surface.borders[border];
        if ((first == nullptr) != (second == nullptr) || (first && first->kept != second->kept))
            return fmt::format("border {}", border);
    }
    return {};
}

} // namespace proveout
