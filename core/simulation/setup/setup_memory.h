// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"
#include "core/decimation/surface/map_memory.h"
#include "core/simulation/setup/setup.h"
#include "core/zmap/stock.h"

namespace proveout {

/// The memory of a simulation, bytes.
struct MemoryForecast {
    double expected = 0; ///< with a machined surface
    double most = 0;     ///< with any surface
};

/// What a simulation makes of its map, and keeps beside it. `shown`: frames of it are shown.
[[nodiscard]] MapOutputs simulationOutputs(const Setup& setup, bool shown = false);

/// Before anything is allocated; `grid` is that of the setup. Pure.
[[nodiscard]] MemoryForecast memoryForecast(const Setup& setup, const Grid& grid,
                                            const DecimationParameters& parameters, bool shown = false);

/// Refuses a setup of which not even the z-map fits into `limitBytes`; the triangles are watched while they
/// are made (SurfaceMemory). Errors: stock, grid, memory.
[[nodiscard]] Result<void> checkSetupMemory(const Setup& setup, const DecimationParameters& parameters,
                                            double limitBytes, bool shown = false);

} // namespace proveout
