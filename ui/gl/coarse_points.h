// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "core/decimation/regions/region_grid.h"
#include "core/zmap/stock.h"

namespace proveout {

/// A coarser grid of points of a grid itself: every step-th point along each axis, and the last one. Its last
/// cells may be narrower. Value type.
struct CoarsePoints {
    int step = 1;
    glm::ivec2 count{0, 0};

    [[nodiscard]] static CoarsePoints of(const Grid& grid, int step);
    /// With the smallest step, a power of two of at least 2, at which they take at most `bytes` and have at
    /// most `most` points along a side.
    [[nodiscard]] static CoarsePoints within(const Grid& grid, std::size_t bytes, int most);

    [[nodiscard]] std::size_t bytes() const; ///< with one float per point
};

/// How many triangles regions without meshes have if each is drawn from every step-th of its points along
/// each axis, and its last ones.
[[nodiscard]] std::size_t coarseTriangles(const RegionGrid& regions, int step);
/// The smallest step, a power of two, with which they have at most `most` triangles; if there is none, that
/// with which each region has two.
[[nodiscard]] int stepWithin(const RegionGrid& regions, std::size_t most);

/// The points of a coarser grid that are in a part of an axis.
struct SampledPoints {
    int first = 0;           ///< the index of the first one in the coarser grid
    std::vector<int> points; ///< their indices in the grid, ascending
};
/// Those in [from, to) of an axis with `count` points (at least 2).
[[nodiscard]] SampledPoints sampledPoints(int from, int to, int count, int step);

} // namespace proveout
