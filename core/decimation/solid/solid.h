// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/triangle_mesh.h"
#include "core/base/work_context.h"
#include "core/decimation/regions/parameters.h"
#include "core/decimation/regions/region_mesh.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Vertices and edges where two sheets of the solid would touch are separated by this much, mm.
inline constexpr double kPinchGap = 1e-4;

/// Closes a surface by walls and a floor into a solid: closed, 2-manifold, normals outwards. Triangles
/// entirely on the stock's floor are holes: they are removed from top and floor; vertices and edges where
/// sheets would touch are split and separated by kPinchGap, or by four steps of float32 if the coordinates
/// are so large that STL could not hold the gap. Empty if nothing of the stock is left, or if the context was
/// stopped. `surface` must cover the map without cracks (SurfaceSnapshot::triangles() of BorderRule::shared);
/// moved in, its memory is reused for the solid. Its vertices are points of the grid. Any thread.
[[nodiscard]] TriangleMesh closeSolid(const ZMapSnapshot& zmap, std::vector<LatticeTriangle> surface,
                                      const WorkContext& context = {});

/// A solid of closeWithWalls().
struct WalledSolid {
    TriangleMesh mesh;
    std::optional<double> largestErrorMm; ///< measureSolidError() at the level promised; unknown without an
                                          ///< allowance, or if the context was stopped
};

/// The same with walls where they stand, if `zmap` has them and `surface` has their points. `promised`: what
/// the surface was made for; walls are simplified within its allowance as well, and keep all their points if
/// there is none. `coordinates`: of the file. Where other walls are so near that the grid does not resolve
/// them, so that the solid would be farther from the map than allowed, or turned over, `zmap` loses them, and
/// they are drawn at its points. Nothing if that does not help.
[[nodiscard]] std::optional<WalledSolid>
closeWithWalls(ZMapSnapshot& zmap, std::vector<LatticeTriangle> surface, const DecimationParameters& promised,
               CoordinateType coordinates, const WorkContext& context = {});

/// Whether closeSolid() has split and separated vertices of this solid.
[[nodiscard]] bool hasVerticesSetApart(const ZMapSnapshot& zmap, const TriangleMesh& solid);

} // namespace proveout
