// SPDX-License-Identifier: GPL-3.0-or-later
// Many motions into the z-map: binned to the tiles that they may lower, then tile by tile.
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <optional>
#include <span>
#include <vector>

#include "core/cutting/cut_part.h"
#include "core/cutting/cutting.h"
#include "core/cutting/lower_tile.h"
#include "core/cutting/tiles_under.h"

namespace proveout {

namespace {

// Motions are binned in portions: of that many tiles in all the records take 20 MB, of that many motions the
// sweeps 20 MB, more where cutters have several profiles. Between two of them threads wait for each other.
constexpr std::size_t kTilesOfPortion = 500'000;
constexpr std::size_t kMotionsOfPortion = 32'768;
/// Prepared at once, by several threads.
constexpr std::size_t kMotionsOfBatch = 128;

/// A motion, and the tiles that it may lower; neither where it cuts nothing.
struct PlacedSweep {
    std::optional<PreparedSweep> prepared;
    std::vector<std::size_t> tiles;
};

PlacedSweep place(const ZMap& zmap, const CutterMotion& one) {
    PlacedSweep placed;
    if (one.cutter == nullptr)
        return placed;
    placed.prepared.emplace(*one.cutter, one.motion, zmap);
    placed.prepared->mark = one.mark;
    if (!placed.prepared->sweep.empty())
        placed.tiles = tilesToLower(zmap, placed.prepared->sweep);
    return placed;
}

std::vector<PlacedSweep> placeAll(const ZMap& zmap, std::span<const CutterMotion> motions) {
    constexpr std::size_t kWorthATask = 16;
    std::vector<PlacedSweep> placed(motions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, motions.size(), kWorthATask),
                      [&](const auto& range) {
                          for (std::size_t k = range.begin(); k != range.end(); ++k)
                              placed[k] = place(zmap, motions[k]);
                      });
    return placed;
}

/// Some motions of a sequence, and the tiles that they may lower.
class Portion {
public:
    /// From motion `first` on.
    Portion(const ZMap& zmap, std::span<const CutterMotion> motions, std::size_t first) : m_end(first) {
        std::vector<std::uint32_t> counts(zmap.tileCount());
        std::vector<Pair> pairs;
        const auto full = [&] {
            return m_end == motions.size() || pairs.size() >= kTilesOfPortion ||
                   m_sweeps.size() >= kMotionsOfPortion;
        };
        while (!full()) {
            const std::size_t count = std::min(kMotionsOfBatch, motions.size() - m_end);
            for (PlacedSweep& placed : placeAll(zmap, motions.subspan(m_end, count))) {
                if (full())
                    break;
                add(std::move(placed), counts, pairs);
                ++m_end;
            }
        }
        bin(counts, pairs);
    }

    [[nodiscard]] std::size_t end() const { return m_end; } ///< the first motion that is not among them

    /// False where it was stopped: some tiles were lowered then.
    bool lower(ZMap& zmap, const std::stop_token& stop, std::vector<CutRecord>& records,
               Provenance* provenance) {
        std::vector<CutRecord> parts(m_order.size());
        const bool complete = lowerTiles(zmap, stop, [&](std::size_t k, PassTable&) {
            const std::span own(parts.begin() + m_begins[k], orderOf(k).size());
            Provenance::Marks* marks = provenance == nullptr ? nullptr : &provenance->tile(m_tiles[k]);
            return lowerTile(zmap, m_tiles[k], m_sweeps, orderOf(k), own, stop, marks);
        });
        // Of each motion in the order of its tiles, as where it is cut alone.
        for (std::size_t k = 0; k < m_order.size(); ++k)
            records[m_motions[m_order[k]]].add(parts[k]);
        return complete;
    }

    /// The same without records.
    bool lowerByAll(ZMap& zmap, const GridPart& place, const std::stop_token& stop) {
        return lowerTiles(zmap, stop, [&](std::size_t k, PassTable& table) {
            return lowerTileByAll(zmap, m_tiles[k], m_sweeps, orderOf(k), table, place, stop);
        });
    }

private:
    struct Pair {
        std::uint32_t tile;
        std::uint32_t sweep;
    };

    /// The sweeps over a tile.
    [[nodiscard]] std::span<const std::uint32_t> orderOf(std::size_t k) const {
        return {m_order.begin() + m_begins[k], m_order.begin() + m_begins[k + 1]};
    }

    template<class LowerTile>
    bool lowerTiles(ZMap& zmap, const std::stop_token& stop, const LowerTile& lowerOne) {
        std::vector<TileCut> done(m_tiles.size());
        std::atomic<bool> complete = true;
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, m_tiles.size()), [&](const auto& range) {
            PassTable table;
            for (std::size_t k = range.begin(); k != range.end() && complete; ++k) {
                done[k] = lowerOne(k, table);
                if (!done[k].complete || stop.stop_requested())
                    complete = false;
            }
        });
        for (std::size_t k = 0; k < m_tiles.size(); ++k) {
            if (done[k].copy)
                zmap.adoptTile(m_tiles[k], std::move(done[k].copy));
        }
        return complete;
    }

    void add(PlacedSweep placed, std::vector<std::uint32_t>& counts, std::vector<Pair>& pairs) {
        if (placed.tiles.empty())
            return;
        for (const std::size_t tile : placed.tiles) {
            pairs.push_back({static_cast<std::uint32_t>(tile), static_cast<std::uint32_t>(m_sweeps.size())});
            ++counts[tile];
        }
        m_sweeps.push_back(std::move(*placed.prepared));
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

/// Calls `lower` with one portion after the other. Where it says that it was stopped, the map becomes what it
/// was, and the answer is false.
template<class Lower>
bool byPortions(ZMap& zmap, std::span<const CutterMotion> motions, const std::stop_token& stop,
                const Lower& lower) {
    std::optional<ZMapSnapshot> before;
    if (stop.stop_possible())
        before = zmap.snapshot();
    for (std::size_t next = 0; next < motions.size();) {
        Portion portion(zmap, motions, next);
        if (!lower(portion)) {
            zmap = ZMap(*before);
            return false;
        }
        next = portion.end();
    }
    return true;
}

} // namespace

std::optional<std::vector<CutRecord>> cut(ZMap& zmap, std::span<const CutterMotion> motions,
                                          const std::stop_token& stop, Provenance* provenance) {
    std::vector<CutRecord> records(motions.size());
    if (!byPortions(zmap, motions, stop,
                    [&](Portion& portion) { return portion.lower(zmap, stop, records, provenance); }))
        return std::nullopt;
    for (CutRecord& record : records)
        record.removedMm3 *= zmap.grid().hx * zmap.grid().hy;
    return records;
}

bool cutHeights(ZMap& zmap, std::span<const CutterMotion> motions, const std::stop_token& stop) {
    return cutHeights(zmap, GridPart(zmap.grid()), motions, stop);
}

bool cutHeights(ZMap& zmap, const GridPart& place, std::span<const CutterMotion> motions,
                const std::stop_token& stop) {
    return byPortions(zmap, motions, stop,
                      [&](Portion& portion) { return portion.lowerByAll(zmap, place, stop); });
}

} // namespace proveout
