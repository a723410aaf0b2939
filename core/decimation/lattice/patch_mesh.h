// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the working mesh of a patch into the mesh of a region, with its measured error.
#pragma once

#include <cstdint>

#include "core/decimation/lattice/lattice_triangulation.h"
#include "core/decimation/regions/parameters.h"
#include "core/decimation/regions/region_mesh.h"

namespace proveout {

/// The living triangles of `mesh`, whose patch is at `rect` of the grid. `largestError` is the largest of the
/// triangles' own distances, of the deviation of the outline and, at the surface level, of all crossings with
/// the canonical mesh; all rounding is included.
[[nodiscard]] RegionMesh regionMeshOf(const LatticeTriangulation& mesh, const RegionPatch& patch,
                                      const RegionGrid& grid, const IndexRect& rect,
                                      const DecimationParameters& parameters);

/// The largest float that is not above a number.
[[nodiscard]] float floatNotAbove(double number);

} // namespace proveout
