// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace proveout {

/// A smaller depth, in mm, does not count as removed: a motion that ends where an earlier cut ended may lower
/// points by the possible difference of two exact cuts, 1 µm each.
inline constexpr double kNothingRemoved = 2e-3;

/// The known values of one motion block after it was executed: 40 bytes.
struct BlockStatistics {
    std::uint32_t facesShown = 0;       ///< triangles of the surface after the block
    std::uint32_t facesFull = 0;        ///< triangles without decimation
    std::uint32_t regionsDirty = 0;     ///< regions drawn from the z-map after the block
    std::uint32_t regionsDecimated = 0; ///< regions decimated at the end of the block
    float cutSeconds = 0;
    float decimationSeconds = 0;
    float maxDepth = 0;         ///< largest height removed at a point, mm: the axial depth
    float radialEngagement = 0; ///< the width that was cut across the path, mm, to within one spacing of the
                                ///< grid
    double removedMm3 = 0;      ///< the exact volume that the z-map lost

    /// If false, the block moved through air.
    [[nodiscard]] bool cuts() const { return double{maxDepth} > kNothingRemoved; }
};
static_assert(sizeof(BlockStatistics) == 40);

/// The known values of one drawn frame, which covers the blocks (firstBlock, lastBlock].
struct FrameStatistics {
    std::uint32_t firstBlock = 0;
    std::uint32_t lastBlock = 0;
    float cutSeconds = 0;
    float decimationSeconds = 0;
    float uploadSeconds = 0;
    float drawSeconds = 0;
};

} // namespace proveout
