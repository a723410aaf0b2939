// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts many motions into the z-map: they are binned to the tiles that they may lower, then cut tile by tile.
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/cutting/cut/cut_part.h"
#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/lower_tile.h"
#include "core/cutting/cut/sequence_cutter.h"
#include "core/cutting/cut/tiles_under.h"

namespace proveout {

namespace {

// Motions are binned in portions. With this many tiles in total, the records need 20 MB; with this many
// motions, the sweeps need 20 MB, more if cutters have several profiles. Threads wait for each other between
// two portions.
constexpr std::size_t kTilesOfPortion = 500'000;
constexpr std::size_t kMotionsOfPortion = 32'768;
/// Motions prepared at once, by several threads.
constexpr std::size_t kMotionsOfBatch = 1024;

} // namespace

/// Some motions of a sequence, and the tiles that they may lower. One object is filled again and again, in
/// place and by several threads: when each portion had its own memory, a tenth of the time on two threads
/// went into memory that one thread allocated and freed while the other waited.
class SequenceCutter::Portion {
public:
    /// Prepares for a sequence of so many motions.
    void begin(const ZMap& zmap, std::size_t motions) {
        if (const std::size_t most = std::min(motions, kMotionsOfPortion); m_sweeps.size() < most) {
            m_sweeps.resize(most);
            m_tilesOf.resize(most);
            m_isRecorded.resize(most);
        }
        m_next.resize(zmap.tileCount());
    }

    /// Fills the portion with motions from `first` on.
    void fill(const ZMap& zmap, std::span<const CutterMotion> motions, std::size_t first) {
        m_first = first;
        m_count = 0;
        std::size_t pairs = 0;
        const std::size_t most = std::min(m_sweeps.size(), motions.size() - first);
        while (m_count < most && pairs < kTilesOfPortion) {
            const std::size_t batch = std::min(kMotionsOfBatch, most - m_count);
            placeAll(zmap, motions.subspan(first + m_count, batch));
            for (const std::size_t end = m_count + batch; m_count < end && pairs < kTilesOfPortion; ++m_count)
                pairs += m_tilesOf[m_count].size();
        }
        bin(pairs);
    }

    [[nodiscard]] std::size_t end() const { return m_first + m_count; } ///< index after the last motion

    /// False if it was stopped; some tiles have been lowered then.
    bool lower(ZMap& zmap, const std::stop_token& stop, std::vector<CutRecord>& records,
               Provenance* provenance) {
        const bool all = provenance != nullptr || m_recordedPairs == m_order.size();
        const std::size_t parts = all ? m_order.size() : m_recordedPairs;
        m_parts.resize(std::max(m_parts.size(), parts));
        const bool complete = lowerTiles(zmap, stop, [&](std::size_t k, PassTable& table) {
            if (!all)
                return lowerTileInTurn(zmap, m_tiles[k], m_sweeps, orderOf(k),
                                       std::span(m_parts).subspan(m_firstPart[k]), table, stop);
            Provenance::Marks* marks = provenance == nullptr ? nullptr : &provenance->tile(m_tiles[k]);
            return lowerTile(zmap, m_tiles[k], m_sweeps, orderOf(k),
                             std::span(m_parts).subspan(m_begins[k], orderOf(k).size()), stop, marks);
        });
        // The parts of each motion are added in the order of its tiles, as when it is cut alone.
        for (std::size_t k = 0, part = 0; complete && part < parts; ++k) {
            if (all || m_isRecorded[m_order[k]] != 0)
                records[m_first + m_order[k]].add(m_parts[part++]);
        }
        return complete;
    }

    /// The same without records.
    bool lowerByAll(ZMap& zmap, const GridPart& place, const std::stop_token& stop) {
        return lowerTiles(zmap, stop, [&](std::size_t k, PassTable& table) {
            return lowerTileByAll(zmap, m_tiles[k], m_sweeps, orderOf(k), table, place, stop);
        });
    }

private:
    /// The sweeps that may lower a tile, ascending.
    [[nodiscard]] std::span<const std::uint32_t> orderOf(std::size_t k) const {
        return {m_order.begin() + m_begins[k], m_order.begin() + m_begins[k + 1]};
    }

    template<class LowerTile>
    bool lowerTiles(ZMap& zmap, const std::stop_token& stop, const LowerTile& lowerOne) {
        std::vector<TileCut> done(m_tiles.size());
        std::atomic<bool> complete = true;
        inParallelRanges(m_tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
            std::unique_ptr<PassTable> table = borrowTable();
            for (std::size_t k = begin; k < end && complete; ++k) {
                done[k] = lowerOne(k, *table);
                if (!done[k].complete || stop.stop_requested())
                    complete = false;
            }
            giveBack(std::move(table));
        });
        for (std::size_t k = 0; k < m_tiles.size(); ++k) {
            if (done[k].copy)
                zmap.adoptTile(m_tiles[k], std::move(done[k].copy));
        }
        return complete;
    }

    /// Scratch memory for one thread; called by several.
    [[nodiscard]] std::unique_ptr<PassTable> borrowTable() {
        const std::lock_guard lock(m_mutex);
        if (m_tables.empty())
            return std::make_unique<PassTable>();
        std::unique_ptr<PassTable> table = std::move(m_tables.back());
        m_tables.pop_back();
        return table;
    }
    void giveBack(std::unique_ptr<PassTable> table) {
        const std::lock_guard lock(m_mutex);
        m_tables.push_back(std::move(table));
    }

    /// Places motions after those that are placed already.
    void placeAll(const ZMap& zmap, std::span<const CutterMotion> motions) {
        constexpr std::size_t kWorthATask = 16;
        inParallelRanges(motions.size(), kWorthATask, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                place(zmap, motions[k], m_count + k);
        });
    }

    /// A motion that cuts nothing has no tiles.
    void place(const ZMap& zmap, const CutterMotion& one, std::size_t at) {
        m_tilesOf[at].clear();
        if (one.cutter == nullptr)
            return;
        m_sweeps[at] = PreparedSweep(*one.cutter, one.motion, zmap, one.continues);
        m_sweeps[at].mark = one.mark;
        m_sweeps[at].recorded = one.recorded;
        m_isRecorded[at] = one.recorded ? 1 : 0;
        if (!m_sweeps[at].sweep.empty())
            tilesToLower(zmap, m_sweeps[at].sweep, m_tilesOf[at]);
    }

    void bin(std::size_t pairs) {
        std::ranges::fill(m_next, 0U);
        for (std::size_t sweep = 0; sweep < m_count; ++sweep) {
            for (const std::size_t tile : m_tilesOf[sweep])
                ++m_next[tile];
        }
        m_tiles.clear();
        m_begins.clear();
        std::uint32_t begin = 0;
        for (std::size_t tile = 0; tile < m_next.size(); ++tile) {
            const std::uint32_t count = std::exchange(m_next[tile], begin);
            if (count == 0)
                continue;
            m_tiles.push_back(tile);
            m_begins.push_back(begin);
            begin += count;
        }
        m_begins.push_back(begin);
        m_order.resize(pairs);
        for (std::size_t sweep = 0; sweep < m_count; ++sweep) {
            for (const std::size_t tile : m_tilesOf[sweep])
                m_order[m_next[tile]++] = static_cast<std::uint32_t>(sweep);
        }
        m_firstPart.clear();
        m_recordedPairs = 0;
        for (std::size_t k = 0; k < m_tiles.size(); ++k) {
            m_firstPart.push_back(m_recordedPairs);
            for (const std::uint32_t sweep : orderOf(k))
                m_recordedPairs += m_isRecorded[sweep];
        }
    }

    std::size_t m_first = 0;
    std::size_t m_count = 0;
    std::vector<PreparedSweep> m_sweeps;
    std::vector<std::vector<std::size_t>> m_tilesOf; ///< by sweep, ascending
    std::vector<std::uint32_t> m_next;               ///< by tile of the map: where bin() continues
    std::vector<std::size_t> m_tiles;                ///< ascending
    std::vector<std::uint32_t> m_begins;    ///< by tile of m_tiles: the index of its first sweep in m_order;
                                            ///< finally the end of the last
    std::vector<std::uint32_t> m_order;     ///< sweeps, ascending within a tile
    std::vector<std::uint8_t> m_isRecorded; ///< by sweep
    std::size_t m_recordedPairs = 0;        ///< entries of m_order whose sweep is recorded
    std::vector<std::size_t> m_firstPart;   ///< by tile of m_tiles: how many of them come before it
    std::vector<CutRecord> m_parts;         ///< for each of them, or for each entry of m_order
    std::mutex m_mutex;
    std::vector<std::unique_ptr<PassTable>> m_tables; ///< not in use
};

SequenceCutter::SequenceCutter() = default;
SequenceCutter::~SequenceCutter() = default;

/// Calls `lower` with one portion after the other. If it reports that it was stopped, the map is restored,
/// and the result is false.
template<class Lower>
bool SequenceCutter::byPortions(ZMap& zmap, std::span<const CutterMotion> motions,
                                const std::stop_token& stop, const Lower& lower) {
    std::optional<ZMapSnapshot> before;
    if (stop.stop_possible())
        before = zmap.snapshot();
    if (!m_portion)
        m_portion = std::make_unique<Portion>();
    m_portion->begin(zmap, motions.size());
    for (std::size_t next = 0; next < motions.size(); next = m_portion->end()) {
        m_portion->fill(zmap, motions, next);
        if (!lower(*m_portion)) {
            zmap = ZMap(*before);
            return false;
        }
    }
    return true;
}

bool SequenceCutter::cut(ZMap& zmap, std::span<const CutterMotion> motions, std::vector<CutRecord>& records,
                         const std::stop_token& stop, Provenance* provenance) {
    records.assign(motions.size(), {});
    if (!byPortions(zmap, motions, stop,
                    [&](Portion& portion) { return portion.lower(zmap, stop, records, provenance); }))
        return false;
    for (CutRecord& record : records)
        record.removedMm3 *= zmap.grid().hx * zmap.grid().hy;
    return true;
}

bool SequenceCutter::cutHeights(ZMap& zmap, const GridPart& place, std::span<const CutterMotion> motions,
                                const std::stop_token& stop) {
    return byPortions(zmap, motions, stop,
                      [&](Portion& portion) { return portion.lowerByAll(zmap, place, stop); });
}

std::optional<std::vector<CutRecord>> cut(ZMap& zmap, std::span<const CutterMotion> motions,
                                          const std::stop_token& stop, Provenance* provenance) {
    std::vector<CutRecord> records;
    if (!SequenceCutter().cut(zmap, motions, records, stop, provenance))
        return std::nullopt;
    return records;
}

bool cutHeights(ZMap& zmap, std::span<const CutterMotion> motions, const std::stop_token& stop) {
    return cutHeights(zmap, GridPart(zmap.grid()), motions, stop);
}

bool cutHeights(ZMap& zmap, const GridPart& place, std::span<const CutterMotion> motions,
                const std::stop_token& stop) {
    return SequenceCutter().cutHeights(zmap, place, motions, stop);
}

} // namespace proveout
