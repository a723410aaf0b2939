// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/lower_tile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "core/cutting/vector_clones.h"

namespace proveout {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kLanes = 8;
static_assert(Tile::kSize % kLanes == 0);
/// Refreshing a tile's maximum costs about as much as lowering this many points.
constexpr std::uint32_t kRefreshAfter = 1024;

using Row = std::array<float, Tile::kSize>;

/// Sums of one tile, lane by lane: the order of additions is fixed, and the compiler may use vectors.
struct LaneSums {
    std::array<double, kLanes> removed{};
    std::array<float, kLanes> depth{};
    std::array<std::int32_t, kLanes> points{};
};

/// Whether a point would change; what is on the floor already cannot.
PROVEOUT_VECTOR_CLONES bool anyLower(const float* envelope, const float* heights, int count, float floor) {
    std::array<int, kLanes> lower{};
    for (int k = 0; k < count; k += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const auto at = static_cast<std::size_t>(k) + lane;
            const float cut = envelope[at] < floor ? floor : envelope[at];
            lower[lane] |= cut < heights[at] ? 1 : 0;
        }
    }
    return std::any_of(lower.begin(), lower.end(), [](int value) { return value != 0; });
}

/// The minimum of both into `heights`; `removed` is what each point lost.
PROVEOUT_VECTOR_CLONES void lowerRow(const float* envelope, float* heights, float* removed, int count,
                                     float floor, LaneSums& sums) {
    for (int k = 0; k < count; k += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const auto at = static_cast<std::size_t>(k) + lane;
            const float old = heights[at];
            const float cut = envelope[at] < floor ? floor : envelope[at];
            const float now = cut < old ? cut : old;
            const float lost = old - now;
            heights[at] = now;
            removed[at] = lost;
            sums.removed[lane] += static_cast<double>(lost);
            sums.depth[lane] = lost > sums.depth[lane] ? lost : sums.depth[lane];
            sums.points[lane] += lost > 0 ? 1 : 0;
        }
    }
}

double total(const LaneSums& sums) {
    double sum = 0;
    for (const double lane : sums.removed)
        sum += lane;
    return sum;
}

/// The work on one tile, sweep by sweep.
class TileWork {
public:
    TileWork(ZMap& zmap, std::size_t index, const std::stop_token& stop)
        : m_zmap(zmap), m_index(index), m_stop(stop), m_grid(zmap.grid()), m_rect(zmap.tileRect(index)),
          m_floor(zmap.floor()) {
        m_envelope.fill(kInfinity);
    }

    /// Nothing more is lowered once it was stopped.
    CutRecord lower(const PreparedSweep& prepared) {
        m_sums = {};
        // A tile that lies below the cutter as a whole cannot change, nor one that is all on the floor.
        if (static_cast<double>(tile().maximum) <= prepared.sweep.lowest() || tile().maximum <= m_floor)
            return {};
        if (prepared.passes.empty())
            lowerRows(prepared.sweep);
        else
            lowerBlocks(prepared);
        finish(!prepared.passes.empty());
        return m_sums.record;
    }

    TileCut result() { return std::move(m_result); }

private:
    [[nodiscard]] const Tile& tile() const { return m_tile != nullptr ? *m_tile : m_zmap.tile(m_index); }

    [[nodiscard]] bool goesOn() {
        m_result.complete = !m_stop.stop_requested();
        return m_result.complete;
    }

    void lowerBlocks(const PreparedSweep& prepared) {
        const Vec2 first = Vec2(m_grid.x(m_rect.i0), m_grid.y(m_rect.j0)) - prepared.sweep.origin();
        std::uint32_t below = 0;
        for (const StraightPass& pass : prepared.passes)
            below |= blocksBelow(pass.overTile(first.x, first.y), tile().blockMaxima.data(), pass.slack());
        for (; below != 0 && goesOn(); below &= below - 1)
            lowerBlock(std::countr_zero(below), first, prepared.passes);
    }

    void lowerBlock(int block, const Vec2& first, std::span<const StraightPass> passes) {
        if (tile().blockMaxima[static_cast<std::size_t>(block)] <= m_floor)
            return;
        const int i = block % Tile::kBlocks * Tile::kBlockSize;
        const int j = block / Tile::kBlocks * Tile::kBlockSize;
        const Vec2 corner = first + Vec2(i * m_grid.hx, j * m_grid.hy);
        const float* from = &tile().heights[static_cast<std::size_t>(j * Tile::kSize + i)];
        std::size_t stride = Tile::kSize;
        Lowered lowered;
        for (const StraightPass& pass : passes) {
            proveout::lowerBlock(pass.overBlock(corner.x, corner.y), from, stride, m_floor, m_block);
            lowered.add(m_block);
            from = m_block.heights.data();
            stride = BlockHeights::kSize;
        }
        if (lowered.rows != 0)
            take(i, j, lowered);
        if (Tile* own = m_tile != nullptr ? m_tile : m_zmap.ownedTile(m_index))
            own->blockMaxima[static_cast<std::size_t>(block)] = m_block.maximum;
    }

    /// The points of a block that became lower by any of several passes.
    struct Lowered {
        std::array<std::uint16_t, BlockHeights::kSize> columns{}; ///< a bit a column, by row
        std::uint32_t rows = 0;                                   ///< a bit a row

        void add(const BlockHeights& block) {
            rows |= block.rows;
            for (std::size_t row = 0; row < columns.size(); ++row)
                columns[row] |= block.lowered[row];
        }
    };

    /// The block whose first point is (i, j) of the tile.
    void take(int i, int j, const Lowered& lowered) {
        acquire();
        const int i0 = m_rect.i0 + i;
        const int j0 = m_rect.j0 + j;
        const bool inside =
            i0 > 0 && j0 > 0 && i0 + BlockHeights::kSize < m_grid.nx && j0 + BlockHeights::kSize < m_grid.ny;
        if (inside)
            return takeInside(i, j, lowered);
        for (int row = 0; row < BlockHeights::kSize; ++row) {
            if (const std::uint32_t bits = lowered.columns[static_cast<std::size_t>(row)]; bits != 0)
                takeRow(row, i, j + row, bits);
        }
    }

    /// Points that all weigh the same.
    void takeInside(int i, int j, const Lowered& lowered) {
        const BlockLoss loss =
            putRows(m_block, lowered.rows, &m_tile->heights[static_cast<std::size_t>(j * Tile::kSize + i)]);
        m_sums.blocks.sum += loss.sum;
        m_sums.blocks.depth = std::max(m_sums.blocks.depth, loss.depth);
        std::uint32_t columns = 0;
        for (const std::uint32_t bits : lowered.columns) {
            columns |= bits;
            m_sums.record.points += std::popcount(bits);
        }
        const int i0 = m_rect.i0 + i;
        const int j0 = m_rect.j0 + j;
        m_sums.record.changed =
            hull(m_sums.record.changed, {i0 + std::countr_zero(columns), j0 + std::countr_zero(lowered.rows),
                                         i0 + static_cast<int>(std::bit_width(columns)),
                                         j0 + static_cast<int>(std::bit_width(lowered.rows))});
    }

    /// A row of a block in which points became lower.
    void takeRow(int rowOfBlock, int begin, int row, std::uint32_t bits) {
        const bool edge = isEdge(row);
        lowerRow(&m_block.heights[static_cast<std::size_t>(rowOfBlock * BlockHeights::kSize)],
                 &m_tile->heights[static_cast<std::size_t>(row * Tile::kSize + begin)],
                 &m_removed[static_cast<std::size_t>(begin)], BlockHeights::kSize, m_floor,
                 edge ? m_sums.edge : m_sums.inner);
        note(row, {begin + std::countr_zero(bits), begin + static_cast<int>(std::bit_width(bits))}, edge);
    }

    void lowerRows(const Sweep& sweep) {
        const Box3& reach = sweep.reach();
        const double rows = m_rect.height();
        const double lo =
            std::clamp(std::ceil((reach.lo.y - m_grid.y0) / m_grid.hy - 1e-6) - m_rect.j0, 0.0, rows);
        const double hi =
            std::clamp(std::floor((reach.hi.y - m_grid.y0) / m_grid.hy + 1e-6) - m_rect.j0 + 1, 0.0, rows);
        for (int row = static_cast<int>(lo); row < static_cast<int>(hi) && goesOn(); ++row)
            lower(sweep, row);
    }

    void lower(const Sweep& sweep, int row) {
        const RowPoints points{m_grid.x(m_rect.i0), m_grid.hx, m_grid.y(m_rect.j0 + row), m_rect.width()};
        const Columns columns = sweep.row(
            points, &tile().heights[static_cast<std::size_t>(row * Tile::kSize)], m_envelope.data());
        if (columns.empty())
            return;
        const int begin = columns.begin / kLanes * kLanes;
        const int end = (columns.end + kLanes - 1) / kLanes * kLanes;
        lower(row, columns, begin, end);
        std::fill(m_envelope.begin() + begin, m_envelope.begin() + end, kInfinity);
    }

    /// Lowers the whole lanes [begin, end) about the columns that were asked.
    void lower(int row, const Columns& columns, int begin, int end) {
        const auto at = static_cast<std::size_t>(row * Tile::kSize + begin);
        if (!anyLower(&m_envelope[static_cast<std::size_t>(begin)], &tile().heights[at], end - begin,
                      m_floor))
            return;
        acquire();
        const bool edge = isEdge(row);
        lowerRow(&m_envelope[static_cast<std::size_t>(begin)], &m_tile->heights[at],
                 &m_removed[static_cast<std::size_t>(begin)], end - begin, m_floor,
                 edge ? m_sums.edge : m_sums.inner);
        note(row, columns, edge);
    }

    /// Of the map: what is there weighs half.
    [[nodiscard]] bool isEdge(int row) const {
        return m_rect.j0 + row == 0 || m_rect.j0 + row == m_grid.ny - 1;
    }

    void acquire() {
        if (m_tile != nullptr)
            return;
        m_tile = m_zmap.ownedTile(m_index);
        if (m_tile == nullptr) {
            m_result.copy = std::make_shared<Tile>(m_zmap.tile(m_index));
            m_tile = m_result.copy.get();
        }
    }

    /// Where points of a row were lowered, and what the first and last column of the map lost.
    void note(int row, const Columns& columns, bool edge) {
        int first = columns.begin;
        while (!(m_removed[static_cast<std::size_t>(first)] > 0))
            ++first;
        int last = columns.end;
        while (!(m_removed[static_cast<std::size_t>(last - 1)] > 0))
            --last;
        const int j = m_rect.j0 + row;
        m_sums.record.changed = hull(m_sums.record.changed, {m_rect.i0 + first, j, m_rect.i0 + last, j + 1});
        const double weight = edge ? 0.25 : 0.5;
        if (first == 0 && m_rect.i0 == 0)
            m_sums.columnHalves += weight * static_cast<double>(m_removed[0]);
        if (m_rect.i0 + last == m_grid.nx)
            m_sums.columnHalves +=
                weight * static_cast<double>(m_removed[static_cast<std::size_t>(last - 1)]);
    }

    void finish(bool byBlocks) {
        CutRecord& record = m_sums.record;
        for (const LaneSums* sums : {&m_sums.inner, &m_sums.edge}) {
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                record.points += sums->points[lane];
                record.maxDepth = std::max(record.maxDepth, static_cast<double>(sums->depth[lane]));
            }
        }
        record.maxDepth = std::max(record.maxDepth, static_cast<double>(m_sums.blocks.depth));
        record.removedMm3 =
            m_sums.blocks.sum + total(m_sums.inner) + total(m_sums.edge) / 2 - m_sums.columnHalves;
        if (record.points == 0)
            return;
        if (byBlocks)
            return m_tile->takeMaximum();
        m_tile->loweredPoints += static_cast<std::uint32_t>(record.points);
        if (m_tile->loweredPoints >= kRefreshAfter)
            m_tile->refreshMaximum();
    }

    ZMap& m_zmap;
    std::size_t m_index;
    const std::stop_token& m_stop;
    const Grid& m_grid;
    IndexRect m_rect;
    float m_floor;
    Tile* m_tile = nullptr;
    BlockHeights m_block;
    Row m_envelope; ///< +infinity between two rows
    Row m_removed;
    TileCut m_result;

    /// Of one sweep.
    struct Sums {
        CutRecord record;
        LaneSums inner;
        LaneSums edge;
        BlockLoss blocks;
        double columnHalves = 0;
    } m_sums;
};

} // namespace

TileCut lowerTile(ZMap& zmap, std::size_t index, std::span<const PreparedSweep> sweeps,
                  std::span<const std::uint32_t> order, std::span<CutRecord> records,
                  const std::stop_token& stop) {
    TileWork work(zmap, index, stop);
    for (std::size_t k = 0; k < order.size(); ++k)
        records[k] = work.lower(sweeps[order[k]]);
    return work.result();
}

} // namespace proveout
