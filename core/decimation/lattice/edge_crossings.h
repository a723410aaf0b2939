// SPDX-License-Identifier: GPL-3.0-or-later
// How far an edge of a region's mesh is from the canonical mesh where it crosses that mesh. The canonical
// mesh consists of whole lines, x = n, y = n, x - y = 2n and x + y = 2n, each a polyline over lattice points.
#pragma once

#include "core/decimation/lattice/lattice_kernels.h"

namespace proveout {

/// A place where an edge crosses an edge of the canonical mesh, and the vertical distance there, mm, rounding
/// included.
struct SurfaceCrossing {
    float distance = 0;
    std::int32_t nearI = 0; ///< the end of the crossed edge that is nearer to the crossing, and the other
    std::int32_t nearJ = 0;
    std::int32_t farI = 0;
    std::int32_t farJ = 0;
};

/// The crossing with the largest distance; distance 0 if there is none. Swapping the ends of the edge does
/// not change the result.
[[nodiscard]] SurfaceCrossing farthestCrossing(const RegionPatch& patch, const PatchVertex& a,
                                               const PatchVertex& b);

/// Whether all crossings are within `limit`.
[[nodiscard]] bool crossingsWithin(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b,
                                   float limit);

/// The point of a side of the patch that is farthest from the chord between two others of that side.
[[nodiscard]] PatchDistance farthestBorderPoint(const RegionPatch& patch, const PatchVertex& a,
                                                const PatchVertex& b);

} // namespace proveout
