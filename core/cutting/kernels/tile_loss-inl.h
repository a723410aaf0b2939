// SPDX-License-Identifier: GPL-3.0-or-later
// What motions remove from a tile. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_TILE_LOSS) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_TILE_LOSS
#undef PROVEOUT_CUTTING_TILE_LOSS
#else
#define PROVEOUT_CUTTING_TILE_LOSS
#endif

#include <algorithm>
#include <bit>

#include "core/cutting/kernels/block_places-inl.h"
#include "core/cutting/kernels/round_envelope-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
using Doubles = hn::Rebind<double, Floats>; // a single lane cannot be halved
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

/// The losses of a tile.
class Losses {
public:
    /// `weights` of the tile's points; null: all weigh 1.
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
    /// Records the columns of a block, one bit each, that were lowered in a row.
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
    V m_from; ///< range of distances from the path
    V m_to;
    TileLoss m_loss;
};

/// Collector for lowerGroup(): the losses of a group of a block. It has no branches: the processor could not
/// predict them, and it works on several rows at once.
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

    HWY_INLINE void add(std::size_t row, std::size_t vector, V before, V now, M lower, V along, V across) {
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
    std::uint32_t* m_marks; ///< of the tile, or null
    std::uint32_t m_mark;
    std::size_t m_column;
    std::size_t m_row;
    V m_deepest[kVectors];
    ColumnSums m_sums;
    V m_from;
    V m_to;
    std::uint64_t m_bits[kGroupRows] = {};
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
