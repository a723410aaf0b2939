// SPDX-License-Identifier: GPL-3.0-or-later
// The inner loops of cutting: lower one tile by straight and round passes, in vectors of the width that the
// processor has. The same bits on every processor and for every width.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "core/cutting/kernels/tile_pass.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The heights of a tile that is being lowered, and their bounds. Blocks of 16 × 16 points are divided into
/// groups of four rows, and these into vectors: a motion is computed only for those that it may lower. Not
/// thread-safe.
class TileUnderWork {
public:
    static constexpr std::size_t kBlock = Tile::kBlockSize;
    static constexpr std::size_t kGroupRows = 4;
    static constexpr std::size_t kGroups = kBlock / kGroupRows;
    static constexpr std::size_t kBlocks = std::size_t{Tile::kBlocks} * Tile::kBlocks;

    /// `tile` is kept by the caller; no height becomes lower than `floor`.
    TileUnderWork(Tile& tile, float floor) : m_tile(&tile), m_floor(floor) {}

    [[nodiscard]] Tile& tile() const { return *m_tile; }
    [[nodiscard]] float floor() const { return m_floor; }
    /// From now on points that lowerByMotion() lowers get this mark; marks are laid out as the heights.
    void mark(std::uint32_t* marks, std::uint32_t mark) {
        m_marks = marks;
        m_mark = mark;
    }
    [[nodiscard]] std::uint32_t* marks() const { return m_marks; }
    [[nodiscard]] std::uint32_t mark() const { return m_mark; }
    /// Discards the known bounds, because others have lowered heights.
    void forget() { m_known = 0; }

    /// The first point of a group of a block.
    [[nodiscard]] float* heights(std::size_t block, std::size_t group) const {
        const std::size_t row = block / Tile::kBlocks * kBlock + group * kGroupRows;
        return &m_tile->heights[row * Tile::kSize + block % Tile::kBlocks * kBlock];
    }
    /// Of each column of a group of a block: an upper bound of its heights.
    [[nodiscard]] float* columnMaxima(std::size_t block, std::size_t group) {
        return &m_columnMaxima[(block * kGroups + group) * kBlock];
    }
    [[nodiscard]] bool isKnown(std::size_t block) const { return (m_known >> block & 1U) != 0; }
    void setKnown(std::size_t block) { m_known |= 1U << block; }

private:
    Tile* m_tile;
    float m_floor;
    std::uint32_t* m_marks = nullptr;
    std::uint32_t m_mark = 0;
    std::uint32_t m_known = 0; ///< one bit per block: whether its columns' maxima are known
    alignas(64) std::array<float, kBlocks * kBlock * kGroups> m_columnMaxima;
};

/// The share of a cell's area by which points count in a volume: 1, and half on the border of the map.
struct PointWeights {
    alignas(64) std::array<float, Tile::kSize> columns;
    std::array<float, Tile::kSize> rows;
};

/// What one motion removed from a tile.
struct TileLoss {
    double sum = 0;  ///< of heights by weight, in an order that does not depend on the width of vectors
    float depth = 0; ///< the largest
    std::int64_t points = 0;
    std::uint64_t columns = 0; ///< one bit each: whether any of their points were lowered
    std::uint64_t rows = 0;
    float engagedFrom = std::numeric_limits<float>::infinity(); ///< as in CutRecord
    float engagedTo = -std::numeric_limits<float>::infinity();
};

/// Whether one of the passes may lower a point of the tile; if false, none does.
[[nodiscard]] bool mayLower(std::span<const TilePass> passes, const Tile& tile, float floor);

/// Lowers the tile by one motion: the passes of all its profiles. `weights`: null if all points weigh 1. If
/// it is stopped, some blocks are unchanged.
[[nodiscard]] TileLoss lowerByMotion(std::span<const TilePass> passes, TileUnderWork& work,
                                     const PointWeights* weights, const std::stop_token& stop);

/// Planes below one pass over all blocks of a tile: height over their middles, change per column and row, and
/// the planes' lowest heights.
struct BlockPlanes {
    using PerBlock = std::array<float, TileUnderWork::kBlocks>;
    alignas(64) PerBlock middle;
    PerBlock perColumn;
    PerBlock perRow;
    PerBlock lowest;
};

/// All passes that may lower a tile, stored field by field so that the bounds of many are computed at once.
/// Not thread-safe.
class PassTable {
public:
    /// The fields from which bounds of passes on straight paths are computed.
    static constexpr std::array kFields = {
        &TilePass::along,  &TilePass::across,    &TilePass::alongX,       &TilePass::acrossX,
        &TilePass::alongY, &TilePass::acrossY,   &TilePass::begin,        &TilePass::end,
        &TilePass::z,      &TilePass::slope,     &TilePass::rise,         &TilePass::radius,
        &TilePass::ring,   &TilePass::aheadRate, &TilePass::aheadRadius2, &TilePass::inner,
        &TilePass::outer,  &TilePass::reach2,    &TilePass::slack,        &TilePass::blocksFrom};

    static constexpr std::size_t kWidest = 16; ///< floats in a vector

    void clear() { m_passes.clear(); }
    void add(const TilePass& pass) { m_passes.push_back(pass); }
    /// Call it after the last add().
    void arrange();

    [[nodiscard]] std::size_t size() const { return m_passes.size(); }
    /// Passes on straight paths come first, once the table is arranged.
    [[nodiscard]] std::size_t straightCount() const { return m_straight; }
    [[nodiscard]] std::span<const TilePass> passes() const { return m_passes; }
    /// Values of one field of the passes on straight paths, padded to whole vectors; the padding has a
    /// `reach2` below 0.
    [[nodiscard]] const float* field(std::size_t index) const { return m_fields.data() + index * m_padded; }

    /// Planes below those passes that may lower a block: height over its middle, change per column and row,
    /// and the planes' lowest height in the block.
    struct Candidates {
        std::vector<float> middle;
        std::vector<float> perColumn;
        std::vector<float> perRow;
        std::vector<float> lowest;
        std::vector<std::int32_t> pass;
    };
    /// The planes of each pass on a round path.
    struct RoundPlanes {
        BlockPlanes planes;
        std::uint32_t blocks; ///< one bit each: the blocks that it may lower
    };
    [[nodiscard]] std::vector<RoundPlanes>& roundPlanes() { return m_roundPlanes; }

    [[nodiscard]] Candidates& candidates() { return m_candidates; }

private:
    std::vector<TilePass> m_passes;
    std::vector<RoundPlanes> m_roundPlanes;
    std::size_t m_straight = 0;
    std::size_t m_padded = 0;
    std::vector<float> m_fields;
    Candidates m_candidates;
};

/// Lowers the tile by all passes, in the fastest order; heights are minima, so the order does not affect
/// them. False if it was stopped, when some passes are done.
[[nodiscard]] bool lowerByAll(PassTable& table, TileUnderWork& work, const std::stop_token& stop);

} // namespace proveout
