// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/setup_memory.h"

namespace proveout {

MapOutputs simulationOutputs(const Setup& setup, bool shown) {
    return {.shown = shown, .shaped = setup.shape.kind != StockKind::box, .walls = shown, .watched = true};
}

MemoryForecast memoryForecast(const Setup& setup, const Grid& grid, const DecimationParameters& parameters,
                              bool shown) {
    const MapOutputs outputs = simulationOutputs(setup, shown);
    return {expectedMapBytes(grid, parameters, outputs), mapBytes(grid, parameters, outputs)};
}

Result<void> checkSetupMemory(const Setup& setup, const DecimationParameters& parameters, double limitBytes,
                              bool shown) {
    const auto grid = makeGrid(setup.stock, setup.spacing);
    if (!grid)
        return tl::unexpected(grid.error());
    return checkMapMemory(setup.stock, *grid, parameters, simulationOutputs(setup, shown), limitBytes);
}

} // namespace proveout
