// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of a tile under one pass: their bounds, and how they are lowered. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_BLOCK_KERNEL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_BLOCK_KERNEL
#undef PROVEOUT_CUTTING_BLOCK_KERNEL
#else
#define PROVEOUT_CUTTING_BLOCK_KERNEL
#endif

#include <bit>

#include "core/cutting/kernels/aligned_envelope-inl.h"
#include "core/cutting/kernels/block_places-inl.h"
#include "core/cutting/kernels/fitted_envelope-inl.h"
#include "core/cutting/kernels/round_envelope-inl.h"
#include "core/cutting/kernels/round_plane-inl.h"
#include "core/cutting/kernels/supporting_plane-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

/// Collector for lowerStrip() when no losses are recorded.
struct NoLosses {
    HWY_INLINE void add(std::size_t, V, V, M, V, V) {}
    HWY_INLINE void end() {}
};

/// Four rows of one vector of a block become the minimum of themselves and an envelope.
template<class Envelope, class Collector>
HWY_INLINE void lowerStrip(const Envelope& envelope, const BlockPlaces& places, std::size_t group,
                           std::size_t k, float* heights, float* columnMaxima, float floor,
                           Collector& collector) {
    const V lowest = all(floor);
    V most = lowest;
    for (std::size_t r = 0; r < kGroupRows; ++r) {
        const std::size_t row = group * kGroupRows + r;
        float* at = heights + r * Tile::kSize;
        const V before = hn::LoadU(kFloats, at);
        const V along = places.alongAt(row, k);
        const V across = places.acrossAt(row, k);
        const Cut cut = cutAt(envelope, row, k, along, across);
        const V z = hn::Max(cut.z, lowest);
        const M lower = hn::And(cut.under, hn::Lt(z, before));
        const V now = hn::IfThenElse(lower, z, before);
        most = hn::Max(most, now);
        hn::StoreU(now, kFloats, at);
        collector.add(r, before, now, lower, along, across);
    }
    hn::StoreU(most, kFloats, columnMaxima);
    collector.end();
}

inline void learnMaxima(TileUnderWork& work, std::size_t block) {
    for (std::size_t group = 0; group < kGroups; ++group) {
        const float* heights = work.heights(block, group);
        float* maxima = work.columnMaxima(block, group);
        for (std::size_t column = 0; column < kBlock; column += kLanes) {
            V most = hn::LoadU(kFloats, heights + column);
            for (std::size_t r = 1; r < kGroupRows; ++r)
                most = hn::Max(most, hn::LoadU(kFloats, heights + r * Tile::kSize + column));
            hn::StoreU(most, kFloats, maxima + column);
        }
    }
    work.setKnown(block);
}

inline void refreshBlockMaximum(TileUnderWork& work, std::size_t block) {
    V most = all(-kInfinity);
    const float* maxima = work.columnMaxima(block, 0);
    for (std::size_t k = 0; k < kGroups * kBlock; k += kLanes)
        most = hn::Max(most, hn::LoadU(kFloats, maxima + k));
    work.tile().blockMaxima[block] = hn::GetLane(hn::MaxOfLanes(kFloats, most));
}

/// A plane below a pass over a block.
struct Plane {
    float middle;
    float perColumn;
    float perRow;
};

/// The strips of a block, one bit each, that may be lowered if the envelope is nowhere below the plane.
HWY_INLINE std::uint64_t stripsAbove(const Plane& plane, const float* columnMaxima, float floor) {
    std::uint64_t strips = 0;
    const V perColumn = all(plane.perColumn);
    const float tilt = plane.perRow < 0 ? -plane.perRow : plane.perRow;
    const float lowestOfRows = plane.middle - 0.5F * (kGroupRows - 1) * tilt;
    for (std::size_t group = 0; group < kGroups; ++group) {
        const float middleRow =
            static_cast<float>(group * kGroupRows) + 0.5F * (kGroupRows - 1) - kBlockMiddle;
        const V ofRow = all(lowestOfRows + middleRow * plane.perRow);
        for (std::size_t k = 0; k < kVectors; ++k) {
            const V columns = hn::Iota(kFloats, static_cast<float>(k * kLanes) - kBlockMiddle);
            const V lowest = hn::Max(productPlus(perColumn, columns, ofRow), all(floor));
            const V maxima = hn::LoadU(kFloats, columnMaxima + group * kBlock + k * kLanes);
            strips |= static_cast<std::uint64_t>(any(hn::Lt(lowest, maxima))) << (group * kVectors + k);
        }
    }
    return strips;
}

inline Plane planeOf(const BlockPlanes& planes, std::size_t block) {
    return {planes.middle[block], planes.perColumn[block], planes.perRow[block]};
}

/// Computes planes below a pass over all blocks of a tile, and returns, one bit each, the blocks that the
/// pass reaches below their maxima.
inline std::uint32_t blocksAbove(const TilePass& pass, const float* blockMaxima, float floor,
                                 BlockPlanes& planes) {
    const bool round = pass.path == TilePass::Path::round;
    const PassLanes lanesOfPass = allLanesOf(pass);
    std::uint32_t found = 0;
    for (std::size_t block = 0; block < kBlocks; block += kLanes) {
        const V index = hn::Iota(kFloats, static_cast<float>(block));
        const V rows = hn::Floor(hn::Mul(index, all(1.0F / Tile::kBlocks)));
        const V columns = minusProduct(rows, all(Tile::kBlocks), index);
        const V first = all(kBlockMiddle - kTileMiddle);
        const V column = productPlus(columns, all(kBlock), first);
        const V row = productPlus(rows, all(kBlock), first);
        const Planes some =
            round ? roundPlanes(pass, column, row) : supportingPlanes(lanesOfPass, column, row);
        const V maxima = hn::LoadU(kFloats, blockMaxima + block);
        const V lowest = some.lowest();
        const M above = hn::Lt(hn::Max(lowest, all(floor)), maxima);
        found |= bitsOf(hn::And(some.reaches, above)) << block;
        hn::StoreU(some.middle, kFloats, planes.middle.data() + block);
        hn::StoreU(some.perColumn, kFloats, planes.perColumn.data() + block);
        hn::StoreU(some.perRow, kFloats, planes.perRow.data() + block);
        hn::StoreU(lowest, kFloats, planes.lowest.data() + block);
    }
    return found;
}

/// Lowers those strips of a block whose bits are set in `strips`. `collectorOf` makes the collector for a
/// strip from its group and its place in the group.
template<class Envelope, class Taking>
HWY_INLINE void lowerEach(const Envelope& envelope, const BlockPlaces& places, TileUnderWork& work,
                          std::size_t block, std::uint64_t strips, const Taking& collectorOf) {
    for (; strips != 0; strips &= strips - 1) {
        const auto strip = static_cast<std::size_t>(std::countr_zero(strips));
        const std::size_t group = strip / kVectors;
        const std::size_t k = strip % kVectors;
        auto collector = collectorOf(group, k);
        lowerStrip(envelope, places, group, k, work.heights(block, group) + k * kLanes,
                   work.columnMaxima(block, group) + k * kLanes, work.floor(), collector);
    }
}

/// The same with the form of the envelope over that block.
template<class Envelope, class Taking>
HWY_INLINE void lowerStrips(const Envelope& envelope, const TilePass& pass, TileUnderWork& work,
                            std::size_t block, std::uint64_t strips, const Taking& collectorOf) {
    const BlockPlaces places(pass, block);
    if constexpr (kOfBlocks<Envelope>) {
        withBlockEnvelope(envelope, pass, places, block, strips, [&](const auto& overBlock) HWY_ATTR {
            const auto own = overBlock; // a local copy, which nothing else can change, stays in registers
            lowerEach(own, places, work, block, strips, collectorOf);
        });
    } else {
        lowerEach(envelope, places, work, block, strips, collectorOf);
    }
    refreshBlockMaximum(work, block);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
