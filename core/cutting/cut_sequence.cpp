// SPDX-License-Identifier: GPL-3.0-or-later
// Many motions into the z-map: binned to the tiles that they may lower, then tile by tile.
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <oneapi/tbb/parallel_for.h>
#include <optional>
#include <span>
#include <vector>

#include "core/cutting/cutting.h"
#include "core/cutting/lower_tile.h"
#include "core/cutting/tiles_under.h"

namespace proveout {

namespace {

// Motions are binned in portions: of that many tiles in all the records take 10 MB, of that many motions the
// sweeps 15 MB, more where cutters have several profiles.
constexpr std::size_t kTilesOfPortion = 200'000;
constexpr std::size_t kMotionsOfPortion = 16'384;

/// Some motions of a sequence, and the tiles that they may lower.
class Portion {
public:
    /// From motion `first` on.
    Portion(const ZMap& zmap, std::span<const CutterMotion> motions, std::size_t first) : m_end(first) {
        std::vector<std::uint32_t> counts(zmap.tileCount());
        std::vector<Pair> pairs;
        for (;
             m_end < motions.size() && pairs.size() < kTilesOfPortion && m_sweeps.size() < kMotionsOfPortion;
             ++m_end)
            addMotion(zmap, motions[m_end], counts, pairs);
        bin(counts, pairs);
    }

    [[nodiscard]] std::size_t end() const { return m_end; } ///< the first motion that is not among them

    /// False where it was stopped: some tiles were lowered then.
    bool lower(ZMap& zmap, const std::stop_token& stop, std::vector<CutRecord>& records) {
        std::vector<TileCut> done(m_tiles.size());
        std::vector<CutRecord> parts(m_order.size());
        std::atomic<bool> complete = true;
        tbb::parallel_for(std::size_t{0}, m_tiles.size(), [&](std::size_t k) {
            if (stop.stop_requested())
                complete = false;
            if (!complete)
                return;
            const std::span order(m_order.begin() + m_begins[k], m_order.begin() + m_begins[k + 1]);
            const std::span own(parts.begin() + m_begins[k], order.size());
            done[k] = lowerTile(zmap, m_tiles[k], m_sweeps, order, own, stop);
            if (!done[k].complete)
                complete = false;
        });
        for (std::size_t k = 0; k < m_tiles.size(); ++k) {
            if (done[k].copy)
                zmap.adoptTile(m_tiles[k], std::move(done[k].copy));
        }
        // Of each motion in the order of its tiles, as where it is cut alone.
        for (std::size_t k = 0; k < m_order.size(); ++k)
            records[m_motions[m_order[k]]].add(parts[k]);
        return complete;
    }

private:
    struct Pair {
        std::uint32_t tile;
        std::uint32_t sweep;
    };

    void addMotion(const ZMap& zmap, const CutterMotion& one, std::vector<std::uint32_t>& counts,
                   std::vector<Pair>& pairs) {
        if (one.cutter == nullptr)
            return;
        PreparedSweep prepared(*one.cutter, one.motion, zmap);
        if (prepared.sweep.empty())
            return;
        const std::vector<std::size_t> tiles = tilesToLower(zmap, prepared.sweep);
        if (tiles.empty())
            return;
        for (const std::size_t tile : tiles) {
            pairs.push_back({static_cast<std::uint32_t>(tile), static_cast<std::uint32_t>(m_sweeps.size())});
            ++counts[tile];
        }
        m_sweeps.push_back(std::move(prepared));
        m_motions.push_back(m_end);
    }

    void bin(const std::vector<std::uint32_t>& counts, const std::vector<Pair>& pairs) {
        std::vector<std::uint32_t> next(counts.size());
        std::uint32_t begin = 0;
        for (std::size_t tile = 0; tile < counts.size(); ++tile) {
            next[tile] = begin;
            if (counts[tile] == 0)
                continue;
            m_tiles.push_back(tile);
            m_begins.push_back(begin);
            begin += counts[tile];
        }
        m_begins.push_back(begin);
        m_order.resize(pairs.size());
        for (const Pair& pair : pairs)
            m_order[next[pair.tile]++] = pair.sweep;
    }

    std::size_t m_end;
    std::vector<PreparedSweep> m_sweeps;
    std::vector<std::size_t> m_motions;  ///< by sweep: which of the sequence it is
    std::vector<std::size_t> m_tiles;    ///< ascending
    std::vector<std::uint32_t> m_begins; ///< by tile: its first in m_order; and the end of the last
    std::vector<std::uint32_t> m_order;  ///< sweeps, ascending within a tile
};

} // namespace

std::optional<std::vector<CutRecord>> cut(ZMap& zmap, std::span<const CutterMotion> motions,
                                          const std::stop_token& stop) {
    std::optional<ZMapSnapshot> before;
    if (stop.stop_possible())
        before = zmap.snapshot();
    std::vector<CutRecord> records(motions.size());
    for (std::size_t next = 0; next < motions.size();) {
        Portion portion(zmap, motions, next);
        if (!portion.lower(zmap, stop, records)) {
            zmap = ZMap(*before);
            return std::nullopt;
        }
        next = portion.end();
    }
    for (CutRecord& record : records)
        record.removedMm3 *= zmap.grid().hx * zmap.grid().hy;
    return records;
}

} // namespace proveout
