// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace proveout {

/// A smaller depth, in mm, does not count as removed: a motion that ends where an earlier cut ended may lower
/// points by the possible difference of two exact cuts, 1 µm each.
inline constexpr double kNothingRemoved = 2e-3;

/// The known values of one motion block after it was executed: 40 bytes. Blocks that are only passed on the
/// way to another one are cut many at once, and have neither a surface nor times of their own.
struct BlockStatistics {
    static constexpr float kNotMeasured = std::numeric_limits<float>::quiet_NaN();

    std::uint32_t facesShown = 0;       ///< triangles of the surface after the block; 0: not measured
    std::uint32_t facesFull = 0;        ///< triangles without decimation
    std::uint32_t regionsDirty = 0;     ///< regions drawn from the z-map after the block, if it was measured
    std::uint32_t regionsDecimated = 0; ///< regions decimated at the end of the block, if it was played
    float cutSeconds = kNotMeasured;
    /// Of several moments made at once (PlayAhead), each has its share of the wall time.
    float decimationSeconds = kNotMeasured;
    // Without a record (Simulation::keepRecordsOf()) the rest is not measured either.
    float maxDepth = 0;         ///< largest height removed at a point, mm: the axial depth
    float radialEngagement = 0; ///< the width that was cut across the path, mm, to within one spacing of the
                                ///< grid
    double removedMm3 = 0;      ///< the exact volume that the z-map lost

    /// Whether the block was executed alone, with the decimation that follows it: its times are known.
    [[nodiscard]] bool isPlayed() const { return !std::isnan(cutSeconds); }
    /// Whether the surface after the block was made: its faces and dirty regions are known.
    [[nodiscard]] bool surfaceIsMeasured() const { return facesShown > 0; }
    [[nodiscard]] bool isRecorded() const { return !std::isnan(removedMm3); }
    /// If false, the block moved through air.
    [[nodiscard]] bool cuts() const { return double{maxDepth} > kNothingRemoved; }
};
static_assert(sizeof(BlockStatistics) == 40);

/// The known values of one drawn frame, which covers the blocks (firstBlock, lastBlock]. Its times are NaN if
/// one of these blocks was not played.
struct FrameStatistics {
    std::uint32_t firstBlock = 0;
    std::uint32_t lastBlock = 0;
    float cutSeconds = 0;
    float decimationSeconds = 0;
    float uploadSeconds = 0;
    float drawSeconds = 0;
};

} // namespace proveout
