// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a map and what is made of it fit, before any of it is taken.
#pragma once

#include <cstddef>

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"
#include "core/zmap/stock.h"

namespace proveout {

/// What is made of a map beside cutting it.
struct MapOutputs {
    bool schedule = true; ///< regions that are decimated while it is cut
    bool whole = false;   ///< all of it decimated in the end (decimatedWhole()), and measured
    bool solid = false;   ///< that, or the full mesh where there is none, closed and written to files
    bool again = false;   ///< the map is kept uncut, and cut once more with a mark a point
};

/// Bytes a point of the grid that the meshes take at most, also where no triangle can be removed and the
/// surface comes down to the floor everywhere.
[[nodiscard]] double meshBytesPerPoint(const DecimationParameters& parameters, const MapOutputs& outputs);

/// The same of the meshes that remain once everything is made.
[[nodiscard]] double heldBytesPerPoint(const DecimationParameters& parameters, const MapOutputs& outputs);

/// The most bytes that a map and what is made of it take at a time.
[[nodiscard]] double mapBytes(const Grid& grid, const DecimationParameters& parameters,
                              const MapOutputs& outputs);

/// Refuses a grid whose map and meshes need more than `limitBytes` (checkMemory() of core/zmap), or that is
/// larger than the method can count.
[[nodiscard]] Result<void> checkMapMemory(const StockBox& stock, const Grid& grid,
                                          const DecimationParameters& parameters, const MapOutputs& outputs,
                                          double limitBytes);

/// Bytes that a RefinedSurface takes beside one of the same regions that has `faces` while it is cut. Noise
/// takes six times what the map does, machined parts a tenth: so this asks what is there, not the worst.
[[nodiscard]] double bytesAtRest(const DecimationParameters& parameters, const Grid& grid, std::size_t faces);

} // namespace proveout
