// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "core/decimation/regions/region_mesh.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// How far the z-map points of a rectangle are from a triangulated surface over it.
struct VerticalError {
    double largest = 0;        ///< mm; infinity if some points are not covered
    std::size_t beyond = 0;    ///< points farther away than `allowance`
    std::size_t uncovered = 0; ///< points without a triangle above or below them
};

/// Measures the vertical distance of every z-map point in `rect` to the triangles, in double; points on
/// shared edges count once, with the larger distance. It is independent of how the triangles were made.
[[nodiscard]] VerticalError measureVerticalError(const ZMapSnapshot& zmap, const IndexRect& rect,
                                                 std::span<const LatticeTriangle> triangles,
                                                 double allowance);

/// The largest vertical distance between the triangles and the canonical full mesh, anywhere on the map, mm;
/// infinity if a point is not covered.
[[nodiscard]] double measureSurfaceError(const ZMapSnapshot& zmap,
                                         std::span<const LatticeTriangle> triangles);

} // namespace proveout
