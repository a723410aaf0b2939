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

/// Sums by column of a vector, in double precision.
class VectorSums {
public:
    HWY_INLINE VectorSums() {
        for (auto& sum : m_sums)
            sum = hn::Zero(Doubles());
    }
    HWY_INLINE void add(V values) {
#if HWY_TARGET == HWY_SCALAR
        m_sums[0] = hn::Add(m_sums[0], hn::PromoteTo(Doubles(), values));
#else
        m_sums[0] = hn::Add(m_sums[0], hn::PromoteTo(Doubles(), hn::LowerHalf(values)));
        const auto upper = hn::UpperHalf(hn::Half<Floats>(), values);
        m_sums[1] = hn::Add(m_sums[1], hn::PromoteTo(Doubles(), upper));
#endif
    }
    HWY_INLINE void add(const VectorSums& other) {
        for (std::size_t k = 0; k < kCount; ++k)
            m_sums[k] = hn::Add(m_sums[k], other.m_sums[k]);
    }
    void store(double* columns) const {
        for (std::size_t k = 0; k < kCount; ++k)
            hn::StoreU(m_sums[k], Doubles(), columns + k * hn::MaxLanes(Doubles()));
    }

private:
    static constexpr std::size_t kCount = kLanes / hn::MaxLanes(Doubles());
    hn::Vec<Doubles> m_sums[kCount];
};

/// Sums by columns of a block: the order of additions is the same for all widths of vectors.
class ColumnSums {
public:
    HWY_INLINE ColumnSums() {} // an implicit one would not be compiled for the target
    /// `vector`: of the rows of a block.
    HWY_INLINE void add(std::size_t vector, const VectorSums& sums) { m_sums[vector].add(sums); }
    [[nodiscard]] double total() const {
        double columns[kBlock];
        for (std::size_t k = 0; k < kVectors; ++k)
            m_sums[k].store(columns + k * kLanes);
        double total = 0;
        for (const double column : columns)
            total += column;
        return total;
    }

private:
    VectorSums m_sums[kVectors];
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
    /// `vector`: of the rows of a block.
    HWY_INLINE void add(std::size_t vector, V deepest, const VectorSums& sums, V from, V to) {
        m_depth = hn::Max(m_depth, deepest);
        m_sums.add(vector, sums);
        m_from = hn::Min(m_from, from);
        m_to = hn::Max(m_to, to);
    }
    /// Records how many points were lowered, in which columns from `column` on, and in which rows from `row`
    /// on, one bit each.
    HWY_INLINE void note(std::int64_t points, std::size_t column, std::uint64_t columns, std::size_t row,
                         std::uint64_t rows) {
        m_loss.points += points;
        m_loss.columns |= columns << column;
        m_loss.rows |= rows << row;
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

/// Collector for lowerStrip(): the losses of a strip of a block. It has no branches: the processor could not
/// predict them, and it works on several rows at once.
class StripLosses {
public:
    HWY_INLINE StripLosses(Losses& losses, const TilePass& pass, const TileUnderWork& work, std::size_t block,
                           std::size_t group, std::size_t vector)
        : m_losses(losses), m_pass(pass), m_marks(work.marks()), m_mark(work.mark()), m_vector(vector),
          m_column(columnOf(block) + vector * kLanes), m_row(rowOf(block) + group * kGroupRows),
          m_deepest(hn::Zero(kFloats)), m_from(all(kInfinity)), m_to(all(-kInfinity)) {}

    HWY_INLINE void add(std::size_t row, V before, V now, M lower, V along, V across) {
        const V beside = besidePath(m_pass, along, across);
        const V lost = hn::Sub(before, now);
        m_sums.add(m_losses.weighed(m_column, m_row + row, lost));
        m_deepest = hn::Max(m_deepest, lost);
        const std::uint64_t bits = bitsOf(lower);
        m_points += std::popcount(bits);
        m_columns |= bits;
        m_rows |= static_cast<std::uint64_t>(bits != 0) << row;
        m_from = hn::Min(m_from, hn::IfThenElse(lower, beside, m_from));
        m_to = hn::Max(m_to, hn::IfThenElse(lower, beside, m_to));
        if (m_marks != nullptr)
            mark((m_row + row) * Tile::kSize + m_column, lower);
    }
    HWY_INLINE void end() {
        m_losses.add(m_vector, m_deepest, m_sums, m_from, m_to);
        m_losses.note(m_points, m_column, m_columns, m_row, m_rows);
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
    std::size_t m_vector; ///< in the rows of the block
    std::size_t m_column;
    std::size_t m_row;
    V m_deepest;
    VectorSums m_sums;
    V m_from;
    V m_to;
    std::int64_t m_points = 0;
    std::uint64_t m_columns = 0; ///< one bit each, from `m_column` on
    std::uint64_t m_rows = 0;    ///< one bit each, from `m_row` on
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
