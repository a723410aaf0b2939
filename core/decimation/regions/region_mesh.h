// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/decimation/regions/region_grid.h"

namespace proveout {

/// A triangle as lattice indices, counter-clockwise seen from +Z. Every vertex of every mesh is a z-map
/// point.
using LatticeTriangle = std::array<std::uint32_t, 3>;

/// A point of a region's border, by its offset from the border's first point.
struct BorderPoint {
    Side side;
    std::uint32_t offset;
};

/// The decimated mesh of one region. Immutable once published.
struct RegionMesh {
    std::vector<LatticeTriangle> triangles;
    double allowance = 0;    ///< mm, the allowance that it was made with
    double largestError = 0; ///< largest vertical distance of a z-map point of the region, mm, measured
    /// Border points that the mesh needs in addition to those it was given (ErrorLevel::surface). If there
    /// are any, the mesh does not fit its neighbours: all regions at these borders must be decimated again,
    /// with these points. Empty once published.
    std::vector<BorderPoint> wanted;
};
using RegionMeshPtr = std::shared_ptr<const RegionMesh>;

/// The full mesh of a region: the canonical 4-8 triangulation (with global indices, "/" joins (i, j) and
/// (i+1, j+1) where i + j is even, "\" otherwise). A border that is not null is drawn as its polyline (see
/// snapToKept); the order of `borders` is that of kSides.
[[nodiscard]] std::vector<LatticeTriangle> fullRegionMesh(const RegionGrid& grid, std::size_t region,
                                                          const std::array<BorderLinePtr, 4>& borders = {});

/// How many triangles fullRegionMesh() makes, without building them.
[[nodiscard]] std::size_t fullRegionFaces(const RegionGrid& grid, std::size_t region,
                                          const std::array<BorderLinePtr, 4>& borders = {});

} // namespace proveout
