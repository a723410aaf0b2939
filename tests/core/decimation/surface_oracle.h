// SPDX-License-Identifier: GPL-3.0-or-later
// The distance of a triangulated surface from the canonical full mesh, everywhere and exact except for the
// rounding of doubles; shares no code with the decimators.
#pragma once

#include <span>

#include "core/decimation/regions/region_mesh.h"
#include "tests/core/decimation/maps.h"

namespace proveout::test {

struct SurfaceDistance {
    double samples = 0; ///< largest vertical distance of a z-map point, mm; infinity if a point is not
                        ///< covered
    double surface = 0; ///< largest vertical distance between the two surfaces, mm
};

/// The difference of two piecewise linear surfaces is largest at a vertex of their overlay: a z-map point, or
/// a crossing of a triangle's edge with a grid line or a diagonal. All of them are evaluated.
SurfaceDistance surfaceDistance(int nx, int ny, const Heights& heights,
                                std::span<const LatticeTriangle> triangles);

/// Largest vertical distance between any point of the triangles' edges and the canonical full mesh, mm.
double edgesDistance(int nx, const Heights& heights, std::span<const LatticeTriangle> triangles);

/// Height of the canonical full mesh at any position of the map, in cells.
double canonicalHeight(int nx, const Heights& heights, double x, double y);

} // namespace proveout::test
