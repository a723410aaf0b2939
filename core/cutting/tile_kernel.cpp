// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled once an instruction set; the best that the processor has is taken where a function is first
// called.
#include "core/cutting/tile_kernel.h"

#include <algorithm>
#include <bit>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/cutting/tile_kernel.cpp"
// Before Highway: its headers are compiled again and again.
#include <hwy/foreach_target.h> // IWYU pragma: keep
#include <hwy/highway.h>

#include "core/cutting/pass_envelope-inl.h"
#include "core/cutting/round_envelope-inl.h"
#include "core/cutting/round_plane-inl.h"
#include "core/cutting/supporting_plane-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

constexpr std::size_t kBlock = TileUnderWork::kBlock;
constexpr std::size_t kBlocks = TileUnderWork::kBlocks;
constexpr std::size_t kGroups = TileUnderWork::kGroups;
constexpr std::size_t kGroupRows = TileUnderWork::kGroupRows;
constexpr float kTileMiddle = (Tile::kSize - 1) / 2.0F;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr std::size_t kLanes = hn::MaxLanes(kFloats); ///< no target of ours has vectors of unknown width
constexpr std::size_t kVectors = kBlock / kLanes;     ///< in a row of a block
HWY_INLINE bool any(M mask) {
    return !hn::AllFalse(kFloats, mask);
}

// Of the first point of a block, from the tile's.
constexpr std::size_t columnOf(std::size_t block) {
    return block % Tile::kBlocks * kBlock;
}
constexpr std::size_t rowOf(std::size_t block) {
    return block / Tile::kBlocks * kBlock;
}
constexpr float kBlockMiddle = (TileUnderWork::kBlock - 1) / 2.0F;

#if HWY_TARGET == HWY_SCALAR
using Doubles = hn::Rebind<double, Floats>; // of one lane there are no halves
#else
using Doubles = hn::Rebind<double, hn::Half<Floats>>;
#endif

/// Sums by columns of a block, in double precision: the order of additions is the same for all widths of
/// vectors.
class ColumnSums {
public:
    HWY_INLINE ColumnSums() {
        for (auto& sum : m_sums)
            sum = hn::Zero(Doubles());
    }
    HWY_INLINE void add(std::size_t vector, V values) {
#if HWY_TARGET == HWY_SCALAR
        m_sums[vector] = hn::Add(m_sums[vector], hn::PromoteTo(Doubles(), values));
#else
        m_sums[2 * vector] = hn::Add(m_sums[2 * vector], hn::PromoteTo(Doubles(), hn::LowerHalf(values)));
        const auto upper = hn::UpperHalf(hn::Half<Floats>(), values);
        m_sums[2 * vector + 1] = hn::Add(m_sums[2 * vector + 1], hn::PromoteTo(Doubles(), upper));
#endif
    }
    HWY_INLINE void add(const ColumnSums& other) {
        for (std::size_t k = 0; k < kCount; ++k)
            m_sums[k] = hn::Add(m_sums[k], other.m_sums[k]);
    }
    [[nodiscard]] double total() const {
        alignas(64) double columns[kBlock];
        for (std::size_t k = 0; k < kCount; ++k)
            hn::Store(m_sums[k], Doubles(), columns + k * hn::MaxLanes(Doubles()));
        double total = 0;
        for (const double column : columns)
            total += column;
        return total;
    }

private:
    static constexpr std::size_t kCount = kBlock / hn::MaxLanes(Doubles());
    hn::Vec<Doubles> m_sums[kCount];
};

/// What is taken off a tile.
class Losses {
public:
    /// Of the tile's points; none: all weigh 1.
    explicit Losses(const PointWeights* weights)
        : m_weights(weights), m_depth(hn::Zero(kFloats)), m_from(all(kInfinity)), m_to(all(-kInfinity)) {}

    /// What a vector of points loses, times its weights.
    [[nodiscard]] HWY_INLINE V weighed(std::size_t column, std::size_t row, V lost) const {
        if (m_weights == nullptr)
            return lost;
        const V weights = hn::LoadU(kFloats, &m_weights->columns[column]);
        return hn::Mul(hn::Mul(lost, weights), all(m_weights->rows[row]));
    }
    HWY_INLINE void add(V deepest, const ColumnSums& sums, V from, V to) {
        m_depth = hn::Max(m_depth, deepest);
        m_sums.add(sums);
        m_from = hn::Min(m_from, from);
        m_to = hn::Max(m_to, to);
    }
    /// The columns of a block, a bit each, that became lower in a row.
    HWY_INLINE void note(std::size_t column, std::size_t row, std::uint64_t bits) {
        m_loss.points += std::popcount(bits);
        m_loss.columns |= bits << column;
        m_loss.rows |= static_cast<std::uint64_t>(bits != 0) << row;
    }
    [[nodiscard]] TileLoss total() const {
        TileLoss total = m_loss;
        total.sum = m_sums.total();
        total.depth = hn::GetLane(hn::MaxOfLanes(kFloats, m_depth));
        total.engagedFrom = hn::GetLane(hn::MinOfLanes(kFloats, m_from));
        total.engagedTo = hn::GetLane(hn::MaxOfLanes(kFloats, m_to));
        return total;
    }

private:
    const PointWeights* m_weights;
    ColumnSums m_sums;
    V m_depth;
    V m_from; ///< beside the path
    V m_to;
    TileLoss m_loss;
};

/// Where the points of a block lie on and beside a path.
struct BlockPlaces {
    V alongColumns[kVectors];
    V acrossColumns[kVectors];
    float along, across, alongY, acrossY;
    float row;

    HWY_INLINE BlockPlaces(const TilePass& pass, std::size_t block)
        : along(pass.along), across(pass.across), alongY(pass.alongY), acrossY(pass.acrossY),
          row(static_cast<float>(rowOf(block)) - kTileMiddle) {
        const float first = static_cast<float>(columnOf(block)) - kTileMiddle;
        for (std::size_t k = 0; k < kVectors; ++k) {
            const V columns = hn::Iota(kFloats, first + static_cast<float>(k * kLanes));
            alongColumns[k] = hn::Mul(all(pass.alongX), columns);
            acrossColumns[k] = hn::Mul(all(pass.acrossX), columns);
        }
    }
    /// Of a row and a vector of it.
    [[nodiscard]] HWY_INLINE V alongAt(std::size_t r, std::size_t k) const {
        return hn::Add(all(along + (row + static_cast<float>(r)) * alongY), alongColumns[k]);
    }
    [[nodiscard]] HWY_INLINE V acrossAt(std::size_t r, std::size_t k) const {
        return hn::Add(all(across + (row + static_cast<float>(r)) * acrossY), acrossColumns[k]);
    }
};

/// For lowerGroup(): nobody wants to know.
struct NoLosses {
    HWY_INLINE void take(std::size_t, std::size_t, V, V, M, V, V) {}
    HWY_INLINE void endGroup() {}
};

/// For lowerGroup(): what a group of a block loses. Nothing is decided on the way: the processor could not
/// foresee it, and works on several rows at once.
class GroupLosses {
public:
    HWY_INLINE GroupLosses(Losses& losses, const TilePass& pass, const TileUnderWork& work, std::size_t block,
                           std::size_t group)
        : m_losses(losses), m_pass(pass), m_marks(work.marks()), m_mark(work.mark()),
          m_column(columnOf(block)), m_row(rowOf(block) + group * kGroupRows), m_from(all(kInfinity)),
          m_to(all(-kInfinity)) {
        for (V& deepest : m_deepest)
            deepest = hn::Zero(kFloats);
    }

    HWY_INLINE void take(std::size_t row, std::size_t vector, V before, V now, M lower, V along, V across) {
        const V beside = besidePath(m_pass, along, across);
        const V lost = hn::Sub(before, now);
        const V weighed = m_losses.weighed(m_column + vector * kLanes, m_row + row, lost);
        m_deepest[vector] = hn::Max(m_deepest[vector], lost);
        m_sums.add(vector, weighed);
        m_bits[row] |= static_cast<std::uint64_t>(bitsOf(lower)) << (vector * kLanes);
        m_from = hn::Min(m_from, hn::IfThenElse(lower, beside, m_from));
        m_to = hn::Max(m_to, hn::IfThenElse(lower, beside, m_to));
        if (m_marks != nullptr)
            mark((m_row + row) * Tile::kSize + m_column + vector * kLanes, lower);
    }
    HWY_INLINE void endGroup() {
        V deepest = m_deepest[0];
        for (std::size_t k = 1; k < kVectors; ++k)
            deepest = hn::Max(deepest, m_deepest[k]);
        m_losses.add(deepest, m_sums, m_from, m_to);
        for (std::size_t r = 0; r < kGroupRows; ++r)
            m_losses.note(m_column, m_row + r, m_bits[r]);
    }

private:
    HWY_INLINE void mark(std::size_t at, M lower) const {
        const hn::RebindToUnsigned<Floats> ints;
        hn::BlendedStore(hn::Set(ints, m_mark), hn::RebindMask(ints, lower), ints, m_marks + at);
    }

    Losses& m_losses;
    const TilePass& m_pass;
    std::uint32_t* m_marks; ///< of the tile, or none
    std::uint32_t m_mark;
    std::size_t m_column;
    std::size_t m_row;
    V m_deepest[kVectors];
    ColumnSums m_sums;
    V m_from;
    V m_to;
    std::uint64_t m_bits[kGroupRows] = {};
};

/// Four rows of a block become the minimum of themselves and an envelope.
template<class Envelope, class Taker>
HWY_INLINE void lowerGroup(const Envelope& envelope, const BlockPlaces& places, std::size_t group,
                           float* heights, float* columnMaxima, float floor, Taker& taker) {
    const V lowest = all(floor);
    for (std::size_t k = 0; k < kVectors; ++k) {
        V most = lowest;
        for (std::size_t r = 0; r < kGroupRows; ++r) {
            const std::size_t row = group * kGroupRows + r;
            float* at = heights + r * Tile::kSize + k * kLanes;
            const V before = hn::LoadU(kFloats, at);
            const V along = places.alongAt(row, k);
            const V across = places.acrossAt(row, k);
            const Cut cut = envelope(along, across);
            const V z = hn::Max(cut.z, lowest);
            const M lower = hn::And(cut.under, hn::Lt(z, before));
            const V now = hn::IfThenElse(lower, z, before);
            most = hn::Max(most, now);
            hn::StoreU(now, kFloats, at);
            taker.take(r, k, before, now, lower, along, across);
        }
        hn::StoreU(most, kFloats, columnMaxima + k * kLanes);
    }
    taker.endGroup();
}

void learnMaxima(TileUnderWork& work, std::size_t block) {
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

void refreshBlockMaximum(TileUnderWork& work, std::size_t block) {
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

/// The groups of a block, a bit each, that may become lower where nothing lies below the plane.
HWY_INLINE std::uint32_t groupsAbove(const Plane& plane, const float* columnMaxima, float floor) {
    std::uint32_t groups = 0;
    const V perColumn = all(plane.perColumn);
    const float tilt = plane.perRow < 0 ? -plane.perRow : plane.perRow;
    const float lowestOfRows = plane.middle - 0.5F * (kGroupRows - 1) * tilt;
    for (std::size_t group = 0; group < kGroups; ++group) {
        const float middleRow =
            static_cast<float>(group * kGroupRows) + 0.5F * (kGroupRows - 1) - kBlockMiddle;
        const V ofRow = all(lowestOfRows + middleRow * plane.perRow);
        for (std::size_t column = 0; column < kBlock; column += kLanes) {
            const V columns = hn::Iota(kFloats, static_cast<float>(column) - kBlockMiddle);
            const V lowest = hn::Max(productPlus(perColumn, columns, ofRow), all(floor));
            const V maxima = hn::LoadU(kFloats, columnMaxima + group * kBlock + column);
            groups |= static_cast<std::uint32_t>(any(hn::Lt(lowest, maxima))) << group;
        }
    }
    return groups;
}

/// Planes below one pass over all blocks of a tile.
Plane planeOf(const BlockPlanes& planes, std::size_t block) {
    return {planes.middle[block], planes.perColumn[block], planes.perRow[block]};
}

/// Planes below a pass over all blocks of a tile, and, a bit each, the blocks that it reaches below their
/// maxima.
std::uint32_t blocksAbove(const TilePass& pass, const float* blockMaxima, float floor, BlockPlanes& planes) {
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

/// Those groups of a block that `groups` has bits of. `taking`: makes a taker for a group.
template<class Envelope, class Taking>
HWY_INLINE void lowerGroups(const Envelope& envelope, const TilePass& pass, TileUnderWork& work,
                            std::size_t block, std::uint32_t groups, const Taking& taking) {
    const BlockPlaces places(pass, block);
    for (; groups != 0; groups &= groups - 1) {
        const auto group = static_cast<std::size_t>(std::countr_zero(groups));
        auto taker = taking(group);
        lowerGroup(envelope, places, group, work.heights(block, group), work.columnMaxima(block, group),
                   work.floor(), taker);
    }
    refreshBlockMaximum(work, block);
}

TileLoss lowerByPass(const TilePass& pass, TileUnderWork& work, const PointWeights* weights) {
    BlockPlanes planes;
    std::uint32_t blocks = blocksAbove(pass, work.tile().blockMaxima.data(), work.floor(), planes);
    if (blocks == 0)
        return {};
    Losses losses(weights);
    withAnyEnvelope(pass, [&](const auto& envelope) HWY_ATTR {
        for (; blocks != 0; blocks &= blocks - 1) {
            const auto block = static_cast<std::size_t>(std::countr_zero(blocks));
            if (!work.isKnown(block))
                learnMaxima(work, block);
            const std::uint32_t groups =
                groupsAbove(planeOf(planes, block), work.columnMaxima(block, 0), work.floor());
            const auto taking = [&](std::size_t group)
                                    HWY_ATTR { return GroupLosses(losses, pass, work, block, group); };
            if (groups != 0)
                lowerGroups(envelope, pass, work, block, groups, taking);
        }
    });
    return losses.total();
}

void lowerBlockByPass(const TilePass& pass, const Plane& plane, TileUnderWork& work, std::size_t block) {
    const std::uint32_t groups = groupsAbove(plane, work.columnMaxima(block, 0), work.floor());
    if (groups == 0)
        return;
    withAnyEnvelope(pass, [&](const auto& envelope) HWY_ATTR {
        lowerGroups(envelope, pass, work, block, groups, [](std::size_t) { return NoLosses(); });
    });
}

/// The heights of a block before several passes.
struct BlockBefore {
    alignas(64) float heights[kBlock * kBlock];

    BlockBefore(const TileUnderWork& work, std::size_t block) {
        const float* from = work.heights(block, 0);
        for (std::size_t row = 0; row < kBlock; ++row) {
            for (std::size_t column = 0; column < kBlock; column += kLanes)
                hn::StoreU(hn::LoadU(kFloats, from + row * Tile::kSize + column), kFloats,
                           &heights[row * kBlock + column]);
        }
    }
    /// `pass`: one of them; all have the same path.
    void compare(const TilePass& pass, const TileUnderWork& work, std::size_t block, Losses& losses) const {
        const BlockPlaces places(pass, block);
        for (std::size_t group = 0; group < kGroups; ++group) {
            const float* to = work.heights(block, group);
            GroupLosses taker(losses, pass, work, block, group);
            for (std::size_t k = 0; k < kVectors; ++k) {
                for (std::size_t r = 0; r < kGroupRows; ++r) {
                    const std::size_t row = group * kGroupRows + r;
                    const V before = hn::LoadU(kFloats, &heights[row * kBlock + k * kLanes]);
                    const V now = hn::LoadU(kFloats, to + r * Tile::kSize + k * kLanes);
                    taker.take(r, k, before, now, hn::Lt(now, before), places.alongAt(row, k),
                               places.acrossAt(row, k));
                }
            }
            taker.endGroup();
        }
    }
};

TileLoss lowerByPasses(std::span<const TilePass> passes, TileUnderWork& work, const PointWeights* weights,
                       const std::stop_token& stop) {
    std::vector<BlockPlanes> planes(passes.size());
    std::vector<std::uint32_t> blocks(passes.size());
    std::uint32_t anyOf = 0;
    for (std::size_t k = 0; k < passes.size(); ++k) {
        blocks[k] = blocksAbove(passes[k], work.tile().blockMaxima.data(), work.floor(), planes[k]);
        anyOf |= blocks[k];
    }
    Losses losses(weights);
    for (; anyOf != 0 && !stop.stop_requested(); anyOf &= anyOf - 1) {
        const auto block = static_cast<std::size_t>(std::countr_zero(anyOf));
        if (!work.isKnown(block))
            learnMaxima(work, block);
        const BlockBefore before(work, block);
        for (std::size_t k = 0; k < passes.size(); ++k) {
            if ((blocks[k] >> block & 1U) != 0)
                lowerBlockByPass(passes[k], planeOf(planes[k], block), work, block);
        }
        before.compare(passes.front(), work, block, losses);
    }
    return losses.total();
}

TileLoss vectorLowerByMotion(std::span<const TilePass> passes, TileUnderWork& work,
                             const PointWeights* weights, const std::stop_token& stop) {
    return passes.size() == 1 ? lowerByPass(passes.front(), work, weights)
                              : lowerByPasses(passes, work, weights, stop);
}

bool vectorMayLower(std::span<const TilePass> passes, const Tile& tile, float floor) {
    BlockPlanes planes;
    for (const TilePass& pass : passes) {
        if (blocksAbove(pass, tile.blockMaxima.data(), floor, planes) != 0)
            return true;
    }
    return false;
}

/// Of all passes those that look lowest at some places of a block, which lie far from each other: once they
/// are cut, most others are above.
class Seeds {
public:
    static constexpr std::size_t kPlaces = 5;

    Seeds() {
        for (std::size_t k = 0; k < kPlaces; ++k) {
            m_lowest[k] = all(kInfinity);
            m_passes[k] = hn::Zero(kFloats);
        }
    }

    /// `passes`: their indices; those that `may` lower the block.
    HWY_INLINE void look(const Planes& planes, M may, V passes) {
        for (std::size_t k = 0; k < kPlaces; ++k) {
            const V ofRow = productPlus(all(kRows[k]), planes.perRow, planes.middle);
            const V z = productPlus(all(kColumns[k]), planes.perColumn, ofRow);
            const M better = hn::And(may, hn::Lt(z, m_lowest[k]));
            m_lowest[k] = hn::IfThenElse(better, z, m_lowest[k]);
            m_passes[k] = hn::IfThenElse(better, passes, m_passes[k]);
        }
    }
    /// One pass that may lower the block.
    HWY_INLINE void look(const Plane& plane, float pass) {
        const Planes planes{all(plane.middle), all(plane.perColumn), all(plane.perRow), {}};
        look(planes, hn::Eq(planes.middle, planes.middle), all(pass));
    }
    [[nodiscard]] HWY_INLINE std::int32_t at(std::size_t place) const {
        alignas(64) float passes[kBlock];
        hn::Store(m_passes[place], kFloats, passes);
        const V least = hn::MinOfLanes(kFloats, m_lowest[place]);
        return static_cast<std::int32_t>(passes[std::countr_zero(bitsOf(hn::Eq(m_lowest[place], least)))]);
    }

private:
    static constexpr float kColumns[kPlaces] = {0, -5, 5, -5, 5};
    static constexpr float kRows[kPlaces] = {0, -5, -5, 5, 5};

    V m_lowest[kPlaces];
    V m_passes[kPlaces]; ///< whole numbers, exact up to 2²⁴
};

/// One block by all passes of a table.
class BlockByAll {
public:
    BlockByAll(PassTable& table, TileUnderWork& work, std::size_t block)
        : m_table(table), m_found(table.candidates()), m_work(work), m_block(block) {}

    void lower() {
        if (maximum() <= m_work.floor())
            return;
        Seeds seeds;
        findCandidates(seeds);
        if (m_count == 0)
            return;
        if (!m_work.isKnown(m_block))
            learnMaxima(m_work, m_block);
        for (std::size_t place = 0; place < Seeds::kPlaces; ++place)
            lowerBySeed(seeds.at(place));
        lowerByRest();
    }

private:
    [[nodiscard]] float maximum() const { return m_work.tile().blockMaxima[m_block]; }

    void findCandidates(Seeds& seeds) {
        const V column = all(static_cast<float>(columnOf(m_block)) + kBlockMiddle - kTileMiddle);
        const V row = all(static_cast<float>(rowOf(m_block)) + kBlockMiddle - kTileMiddle);
        const V most = all(maximum());
        const V floor = all(m_work.floor());
        const hn::RebindToSigned<Floats> ints;
        for (std::size_t k = 0; k < m_table.straightCount(); k += kLanes) {
            const Planes planes = supportingPlanes(lanesOf(m_table, k), column, row);
            const V lowest = planes.lowest();
            const M may = hn::And(planes.reaches, hn::Lt(hn::Max(lowest, floor), most));
            if (!any(may))
                continue;
            hn::CompressStore(planes.middle, may, kFloats, &m_found.middle[m_count]);
            hn::CompressStore(planes.perColumn, may, kFloats, &m_found.perColumn[m_count]);
            hn::CompressStore(planes.perRow, may, kFloats, &m_found.perRow[m_count]);
            hn::CompressStore(lowest, may, kFloats, &m_found.lowest[m_count]);
            seeds.look(planes, may, hn::Iota(kFloats, static_cast<float>(k)));
            m_count += hn::CompressStore(hn::Iota(ints, static_cast<std::int32_t>(k)),
                                         hn::RebindMask(ints, may), ints, &m_found.pass[m_count]);
        }
        findRound(seeds);
        // What fills the last vector is never found.
        for (std::size_t k = 0; k < kLanes; ++k)
            m_found.lowest[m_count + k] = kInfinity;
    }

    /// Of the passes on round paths, which stand behind the others.
    void findRound(Seeds& seeds) {
        const std::vector<PassTable::RoundPlanes>& rounds = m_table.roundPlanes();
        for (std::size_t k = 0; k < rounds.size(); ++k) {
            const BlockPlanes& planes = rounds[k].planes;
            if ((rounds[k].blocks >> m_block & 1U) == 0)
                continue;
            const auto pass = static_cast<std::int32_t>(m_table.straightCount() + k);
            seeds.look(planeOf(planes, m_block), static_cast<float>(pass));
            m_found.middle[m_count] = planes.middle[m_block];
            m_found.perColumn[m_count] = planes.perColumn[m_block];
            m_found.perRow[m_count] = planes.perRow[m_block];
            m_found.lowest[m_count] = planes.lowest[m_block];
            m_found.pass[m_count++] = pass;
        }
    }

    void lowerBySeed(std::int32_t pass) {
        if (isSeed(pass))
            return;
        m_seeds[m_seedCount++] = pass;
        lowerBy(m_table.passes()[static_cast<std::size_t>(pass)], (1U << kGroups) - 1);
    }

    [[nodiscard]] bool isSeed(std::int32_t pass) const {
        for (std::size_t k = 0; k < m_seedCount; ++k) {
            if (m_seeds[k] == pass)
                return true;
        }
        return false;
    }

    void lowerByRest() {
        for (std::size_t k = 0; k < m_count; k += kLanes) {
            const V lowest = hn::LoadU(kFloats, &m_found.lowest[k]);
            std::uint32_t bits = bitsOf(hn::Lt(lowest, all(maximum())));
            for (; bits != 0; bits &= bits - 1)
                lowerByCandidate(k + static_cast<std::size_t>(std::countr_zero(bits)));
        }
    }

    void lowerByCandidate(std::size_t k) {
        if (m_found.lowest[k] >= maximum() || isSeed(m_found.pass[k]))
            return;
        const Plane plane{m_found.middle[k], m_found.perColumn[k], m_found.perRow[k]};
        const std::uint32_t groups = groupsAbove(plane, m_work.columnMaxima(m_block, 0), m_work.floor());
        if (groups != 0)
            lowerBy(m_table.passes()[static_cast<std::size_t>(m_found.pass[k])], groups);
    }

    void lowerBy(const TilePass& pass, std::uint32_t groups) {
        withAnyEnvelope(pass, [&](const auto& envelope) HWY_ATTR {
            lowerGroups(envelope, pass, m_work, m_block, groups, [](std::size_t) { return NoLosses(); });
        });
    }

    PassTable& m_table;
    PassTable::Candidates& m_found;
    TileUnderWork& m_work;
    std::size_t m_block;
    std::size_t m_count = 0; ///< of the candidates found
    std::int32_t m_seeds[Seeds::kPlaces];
    std::size_t m_seedCount = 0;
};

void vectorFindRound(PassTable& table, const Tile& tile, float floor) {
    const std::span<const TilePass> rounds = table.passes().subspan(table.straightCount());
    for (std::size_t k = 0; k < rounds.size(); ++k) {
        PassTable::RoundPlanes& found = table.roundPlanes()[k];
        found.blocks = blocksAbove(rounds[k], tile.blockMaxima.data(), floor, found.planes);
    }
}

void vectorLowerBlockByAll(PassTable& table, TileUnderWork& work, std::size_t block) {
    BlockByAll(table, work, block).lower();
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace proveout {

HWY_EXPORT(vectorMayLower);
HWY_EXPORT(vectorLowerByMotion);
HWY_EXPORT(vectorLowerBlockByAll);
HWY_EXPORT(vectorFindRound);

void PassTable::arrange() {
    const auto rounds = std::stable_partition(m_passes.begin(), m_passes.end(), [](const TilePass& pass) {
        return pass.path == TilePass::Path::straight;
    });
    m_straight = static_cast<std::size_t>(rounds - m_passes.begin());
    m_roundPlanes.resize(m_passes.size() - m_straight);
    m_padded = (m_straight + kWidest - 1) / kWidest * kWidest;
    m_fields.assign(kFields.size() * m_padded, -1.0F);
    for (std::size_t field = 0; field < kFields.size(); ++field) {
        float* values = m_fields.data() + field * m_padded;
        for (std::size_t k = 0; k < m_straight; ++k)
            *values++ = m_passes[k].*kFields[field];
    }
    // Whole vectors are written wherever the last value goes.
    const std::size_t most = m_padded + m_roundPlanes.size() + kWidest;
    for (std::vector<float>* values :
         {&m_candidates.middle, &m_candidates.perColumn, &m_candidates.perRow, &m_candidates.lowest})
        values->resize(std::max(values->size(), most));
    m_candidates.pass.resize(std::max(m_candidates.pass.size(), most));
}

bool mayLower(std::span<const TilePass> passes, const Tile& tile, float floor) {
    return HWY_DYNAMIC_DISPATCH(vectorMayLower)(passes, tile, floor);
}

TileLoss lowerByMotion(std::span<const TilePass> passes, TileUnderWork& work, const PointWeights* weights,
                       const std::stop_token& stop) {
    return HWY_DYNAMIC_DISPATCH(vectorLowerByMotion)(passes, work, weights, stop);
}

bool lowerByAll(PassTable& table, TileUnderWork& work, const std::stop_token& stop) {
    HWY_DYNAMIC_DISPATCH(vectorFindRound)(table, work.tile(), work.floor());
    for (std::size_t block = 0; block < TileUnderWork::kBlocks; ++block) {
        if (stop.stop_requested())
            return false;
        HWY_DYNAMIC_DISPATCH(vectorLowerBlockByAll)(table, work, block);
    }
    return true;
}

} // namespace proveout
#endif
