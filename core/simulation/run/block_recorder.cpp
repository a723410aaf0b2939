// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/block_recorder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/cutting/cut/sequence_cutter.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/run/block_rows.h"

namespace proveout {

namespace {

constexpr std::size_t kBlocksOfLook = 1024;
constexpr std::size_t kPortion = 16'384; ///< motions that are cut at once

/// The tiles under some motions.
class TilesNear {
public:
    explicit TilesNear(const ZMap& zmap)
        : m_grid(zmap.grid()), m_tilesX(zmap.tilesX()), m_tilesY((m_grid.ny + Tile::kSize - 1) / Tile::kSize),
          m_counts(static_cast<std::size_t>((m_tilesX + 1) * (m_tilesY + 1))) {}

    void add(const CutterMotion& one) {
        const IndexRect tiles = tilesUnder(one);
        for (int j = tiles.j0; j < tiles.j1; ++j)
            for (int i = tiles.i0; i < tiles.i1; ++i)
                count(i + 1, j + 1) = 1;
    }
    /// After the last add(): from now on a count is that of the tiles before it in both directions.
    void arrange() {
        for (int j = 1; j <= m_tilesY; ++j)
            for (int i = 1; i <= m_tilesX; ++i)
                count(i, j) += count(i - 1, j) + count(i, j - 1) - count(i - 1, j - 1);
    }
    [[nodiscard]] bool isReachedBy(const CutterMotion& one) const {
        const IndexRect tiles = tilesUnder(one);
        return !tiles.empty() && count(tiles.i1, tiles.j1) - count(tiles.i0, tiles.j1) -
                                         count(tiles.i1, tiles.j0) + count(tiles.i0, tiles.j0) >
                                     0;
    }

private:
    /// In tiles; empty if the motion cuts nothing.
    [[nodiscard]] IndexRect tilesUnder(const CutterMotion& one) const {
        if (one.cutter == nullptr || !one.motion.known() || !withinLimits(one.motion))
            return {};
        const Box3 path = bounds(one.motion);
        const double radius = one.cutter->radius();
        const auto tile = [](double at, double origin, double spacing, int tiles) {
            return static_cast<int>(std::clamp(std::floor((at - origin) / spacing / Tile::kSize), -1.0,
                                               static_cast<double>(tiles)));
        };
        // A point on the rim of a cutter is cut.
        const double slack = (m_grid.hx + m_grid.hy) / 2 + radius;
        return {std::max(tile(path.lo.x - slack, m_grid.x0, m_grid.hx, m_tilesX), 0),
                std::max(tile(path.lo.y - slack, m_grid.y0, m_grid.hy, m_tilesY), 0),
                std::min(tile(path.hi.x + slack, m_grid.x0, m_grid.hx, m_tilesX) + 1, m_tilesX),
                std::min(tile(path.hi.y + slack, m_grid.y0, m_grid.hy, m_tilesY) + 1, m_tilesY)};
    }

    [[nodiscard]] std::size_t at(int i, int j) const {
        return static_cast<std::size_t>(j * (m_tilesX + 1) + i);
    }
    [[nodiscard]] std::int32_t count(int i, int j) const { return m_counts[at(i, j)]; }
    [[nodiscard]] std::int32_t& count(int i, int j) { return m_counts[at(i, j)]; }

    const Grid& m_grid;
    int m_tilesX;
    int m_tilesY;
    std::vector<std::int32_t> m_counts; ///< one row and one column more than tiles
};

class BlockRecorder {
public:
    BlockRecorder(const ZMapSnapshot& stock, const Program& program, const BlockSet& blocks,
                  const Setup& setup, const ToolChoice& tools)
        : m_zmap(stock), m_program(program), m_blocks(blocks), m_setup(setup), m_tools(tools),
          m_near(m_zmap) {}

    bool record(PersistentArray<BlockStatistics>& rows, std::size_t first, const WorkContext& context) {
        if (!findTiles(first, context))
            return false;
        for (std::size_t next = first; next < m_blocks.end();) {
            next = collect(next, context);
            if (context.stopped() || !m_cutter.cut(m_zmap, m_motions, m_records, context.stop))
                return false;
            addUp();
            for (const auto& [block, record] : m_sums)
                addRecord(rows.edit(block), record);
            context.report(static_cast<double>(next - first) / static_cast<double>(m_blocks.end() - first));
        }
        return true;
    }

private:
    bool findTiles(std::size_t first, const WorkContext& context) {
        for (std::size_t block = first; block < m_blocks.end() && !context.stopped(); ++block)
            if (m_blocks.contains(block))
                for (const CutterMotion& one : motionsOf(block, block + 1))
                    m_near.add(one);
        m_near.arrange();
        return !context.stopped();
    }

    /// The end of the blocks that are looked at together from a block on: a cycle may have many motions.
    [[nodiscard]] std::size_t endOfLook(std::size_t block) const {
        const std::size_t first = m_program.blockMotions(block).first;
        const std::size_t most = std::min(block + kBlocksOfLook, m_blocks.end());
        std::size_t end = block + 1;
        while (end < most && m_program.blockMotions(end).last - first <= kPortion)
            ++end;
        return end;
    }

    [[nodiscard]] std::vector<CutterMotion> motionsOf(std::size_t first, std::size_t last) const {
        return cutterMotions(m_program, first, last, m_setup, m_tools);
    }

    /// Collects the motions of a portion that begins with a block; returns the block after it, or an earlier
    /// one if it was stopped.
    std::size_t collect(std::size_t block, const WorkContext& context) {
        m_motions.clear();
        m_sums.clear();
        while (block < m_blocks.end() && m_motions.size() < kPortion && !context.stopped()) {
            const std::size_t last = endOfLook(block);
            for (CutterMotion& one : motionsOf(block, last)) {
                one.recorded = m_blocks.contains(one.mark - 1);
                if (one.recorded || m_near.isReachedBy(one))
                    m_motions.push_back(one);
            }
            for (; block < last; ++block)
                if (m_blocks.contains(block))
                    m_sums.emplace_back(block, CutRecord());
        }
        return block;
    }

    /// Adds the records of motions to those of their blocks; both are in order.
    void addUp() {
        auto sum = m_sums.begin();
        for (std::size_t k = 0; k < m_motions.size(); ++k) {
            if (!m_motions[k].recorded)
                continue;
            while (sum->first + 1 < m_motions[k].mark)
                ++sum;
            sum->second.add(m_records[k]);
        }
    }

    ZMap m_zmap;
    const Program& m_program;
    const BlockSet& m_blocks;
    const Setup& m_setup;
    const ToolChoice& m_tools;
    TilesNear m_near;
    SequenceCutter m_cutter;
    std::vector<CutterMotion> m_motions;
    std::vector<CutRecord> m_records;                      ///< of the motions
    std::vector<std::pair<std::size_t, CutRecord>> m_sums; ///< by block, of the portion
};

} // namespace

bool recordBlocks(PersistentArray<BlockStatistics>& rows, const BlockSet& blocks, const Checkpoint& from,
                  const Program& program, const Setup& setup, const ToolChoice& tools,
                  const WorkContext& context) {
    return BlockRecorder(from.zmap, program, blocks, setup, tools).record(rows, from.block, context);
}

} // namespace proveout
