// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/setup_memory.h"

#include <utility>

#include "core/decimation/surface/map_memory.h"

namespace proveout {

namespace {

MapOutputs mapOutputs(const Setup& setup) {
    return {.shaped = setup.shape.kind != StockKind::box, .watched = true};
}

} // namespace

MemoryForecast memoryForecast(const Setup& setup, const Grid& grid, const DecimationParameters& parameters) {
    const MapOutputs outputs = mapOutputs(setup);
    return {expectedMapBytes(grid, parameters, outputs), mapBytes(grid, parameters, outputs)};
}

Result<void> checkSetupMemory(const Setup& setup, const DecimationParameters& parameters, double limitBytes) {
    const auto grid = makeGrid(setup.stock, setup.spacing);
    if (!grid)
        return tl::unexpected(grid.error());
    return checkMapMemory(setup.stock, *grid, parameters, mapOutputs(setup), limitBytes);
}

} // namespace proveout
