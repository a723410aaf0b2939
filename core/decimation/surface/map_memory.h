// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a map and what is made from it fit into memory, before any of it is allocated.
#pragma once

#include <cstddef>

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"
#include "core/zmap/stock.h"

namespace proveout {

/// What is made from a map in addition to cutting it.
struct MapOutputs {
    bool schedule = true; ///< regions that are decimated while it is cut, and the map of their moment
    bool shown = false;   ///< without such regions: the map of the last frame that was shown
    bool shaped = false;  ///< the uncut stock is not a box: its map is kept, for a restart
    bool whole = false;   ///< the whole map is decimated at the end (decimatedWhole()) and measured
    bool solid = false;   ///< the decimated or else the full mesh, closed and written to files
    bool walls = false;   ///< the map gets its rims and walls
    bool again = false;   ///< the map is kept uncut, and cut a second time with a mark per point
    /// Whoever decimates watches the memory of the triangles (MemoryWatch, surfaceBytes()), so that it need
    /// not be there in advance: triangles are only known when they are made, and machined parts need a tenth
    /// of what noise needs.
    bool watched = false;
};

/// Bytes per point of the grid that the meshes need at most, even if no triangle can be removed and the
/// surface comes down to the floor everywhere. Walls: as many as the closest pattern of holes has.
[[nodiscard]] double meshBytesPerPoint(const DecimationParameters& parameters, const MapOutputs& outputs);

/// The same of what is taken whatever the surface looks like: without the triangles that are watched, and
/// without rims, which are known before a surface is closed with them.
[[nodiscard]] double certainBytesPerPoint(const DecimationParameters& parameters, MapOutputs outputs);

/// Bytes for measuring a surface that exists already, of so many triangles over a map with so many rims, and,
/// if a solid is wanted, closing it.
[[nodiscard]] double surfaceBytes(const Grid& grid, std::size_t faces, std::size_t rims,
                                  const MapOutputs& outputs);

/// The same for the meshes that remain once everything is made.
[[nodiscard]] double heldBytesPerPoint(const DecimationParameters& parameters, const MapOutputs& outputs);

/// Bytes of a map and what is made from it while it is cut, of which the decimated regions have so many
/// triangles.
[[nodiscard]] double scheduledBytes(const Grid& grid, const DecimationParameters& parameters,
                                    const MapOutputs& outputs, std::size_t faces);

/// The largest number of bytes that a map and what is made from it need at any one time.
[[nodiscard]] double mapBytes(const Grid& grid, const DecimationParameters& parameters,
                              const MapOutputs& outputs);

/// The same for a machined surface.
[[nodiscard]] double expectedMapBytes(const Grid& grid, const DecimationParameters& parameters,
                                      const MapOutputs& outputs);

/// Refuses a grid whose map and meshes need more than `limitBytes` (checkMemory() of core/zmap), or that has
/// more points than the method can count. The spacing that it names would fit with any surface.
[[nodiscard]] Result<void> checkMapMemory(const StockBox& stock, const Grid& grid,
                                          const DecimationParameters& parameters, const MapOutputs& outputs,
                                          double limitBytes);

/// Bytes that a RefinedSurface needs in addition to a surface of the same regions that has `faces` during
/// cutting. Noise needs six times as much as the map, machined parts a tenth: so this uses the actual number
/// of faces, not the worst case.
[[nodiscard]] double bytesAtRest(const DecimationParameters& parameters, const Grid& grid, std::size_t faces);

} // namespace proveout
