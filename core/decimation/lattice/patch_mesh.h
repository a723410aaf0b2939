// SPDX-License-Identifier: GPL-3.0-or-later
// From the mesh at work on a patch to the mesh of a region, with the error that was found.
#pragma once

#include <cstdint>

#include "core/decimation/lattice/lattice_triangulation.h"
#include "core/decimation/regions/parameters.h"
#include "core/decimation/regions/region_mesh.h"

namespace proveout {

/// The living triangles of `mesh`, whose patch lies at `rect` of the grid. `largestError` is the largest of
/// the triangles' own distances, of what the outline leaves out and, at the surface level, of all crossings
/// with the canonical mesh; all rounding is counted.
[[nodiscard]] RegionMesh regionMeshOf(const LatticeTriangulation& mesh, const RegionPatch& patch,
                                      const RegionGrid& grid, const IndexRect& rect,
                                      const DecimationParameters& parameters);

/// The largest float that is not above a number.
[[nodiscard]] float floatNotAbove(double number);

} // namespace proveout
