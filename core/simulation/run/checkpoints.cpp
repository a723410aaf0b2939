// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/checkpoints.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <utility>

#include "core/base/stop_watch.h"

namespace proveout {

namespace {

/// More checkpoints than this make neither seeking better nor thinning cheaper.
constexpr std::size_t kMostCheckpoints = 2000;
/// Packing frees some more memory than needed, so that not every checkpoint causes it.
constexpr double kFilledAfterPacking = 0.97;
/// Packing may take this part of the time spent on cutting, plus a short fixed time.
constexpr double kPackShare = 0.25;
constexpr double kFreePackSeconds = 0.02;

} // namespace

void Checkpoints::restart(const Checkpoint& first) {
    assert(first.block == 0);
    m_kept.clear();
    m_bytes = 0;
    m_packSeconds = 0;
    m_stock = first.zmap.stock();
    m_grid = first.zmap.grid();
    m_kept.push_back({first.block, keep(first.zmap, 0), first.removedMm3, first.cutSeconds, 0});
    recount(0);
}

void Checkpoints::add(const Checkpoint& checkpoint) {
    const auto place = std::ranges::lower_bound(m_kept, checkpoint.block, {}, &Kept::block);
    if (place != m_kept.end() && place->block == checkpoint.block)
        return;
    const auto index = static_cast<std::size_t>(std::distance(m_kept.begin(), place));
    m_kept.insert(place, {checkpoint.block, keep(checkpoint.zmap, index), checkpoint.removedMm3,
                          checkpoint.cutSeconds, 0});
    recount(index);
    recount(index + 1);
    fit();
}

/// The tiles of a checkpoint to be inserted at `index`; those of its neighbours are shared.
Checkpoints::Tiles Checkpoints::keep(const ZMapSnapshot& zmap, std::size_t index) const {
    const Tiles* before = index > 0 ? &m_kept[index - 1].tiles : nullptr;
    const Tiles* after = index < m_kept.size() ? &m_kept[index].tiles : nullptr;
    Tiles tiles = before != nullptr ? *before : Tiles(zmap.tileCount());
    for (std::size_t tile = 0; tile < zmap.tileCount(); ++tile) {
        if (before != nullptr && (*before)[tile]->isCopyOf(zmap.tile(tile)))
            continue;
        if (after != nullptr && (*after)[tile]->isCopyOf(zmap.tile(tile)))
            tiles.edit(tile) = (*after)[tile];
        else if (tile > 0 && tiles[tile - 1]->isCopyOf(zmap.tile(tile))) // uncut tiles are one
            tiles.edit(tile) = tiles[tile - 1];
        else
            tiles.edit(tile) = std::make_shared<KeptTile>(zmap.tile(tile));
    }
    return tiles;
}

bool Checkpoints::isDue(std::size_t block, double cutSeconds, std::size_t farBlocks) const {
    return wanted() && (cutSeconds - cutSecondsBefore(block) > kCheckpointSeconds ||
                        block - blockBefore(block) >= farBlocks);
}

void Checkpoints::truncate(std::size_t block) {
    while (m_kept.size() > 1 && m_kept.back().block > block) {
        m_bytes -= m_kept.back().bytes;
        m_kept.pop_back();
    }
}

void Checkpoints::setBudget(std::size_t bytes) {
    m_budget = bytes;
    fit();
}

const Checkpoints::Kept& Checkpoints::keptBefore(std::size_t block) const {
    const auto after = std::ranges::upper_bound(m_kept, block, {}, &Kept::block);
    assert(after != m_kept.begin());
    return *std::prev(after);
}

Checkpoint Checkpoints::before(std::size_t block) const {
    const Kept& kept = keptBefore(block);
    PersistentArray<std::shared_ptr<const Tile>> tiles;
    for (std::size_t tile = 0; tile < kept.tiles.size(); ++tile)
        tiles.push_back(kept.tiles[tile]->tile());
    return {kept.block, ZMapSnapshot(m_stock, m_grid, std::move(tiles)), kept.removedMm3, kept.cutSeconds};
}

void Checkpoints::recount(std::size_t index) {
    if (index >= m_kept.size())
        return;
    Kept& kept = m_kept[index];
    m_bytes -= kept.bytes;
    // The array of pointers is shared by chunks; counting it fully errs on the safe side.
    kept.bytes = kept.tiles.size() * sizeof(std::shared_ptr<KeptTile>);
    for (std::size_t tile = 0; tile < kept.tiles.size(); ++tile) {
        const bool shared = (index > 0 && m_kept[index - 1].tiles[tile] == kept.tiles[tile]) ||
                            (tile > 0 && kept.tiles[tile - 1] == kept.tiles[tile]);
        if (!shared)
            kept.bytes += kept.tiles[tile]->bytes() + (kept.tiles[tile]->isPacked() ? sizeof(KeptTile) : 0);
    }
    m_bytes += kept.bytes;
}

void Checkpoints::fit() {
    if (m_bytes > m_budget && wanted())
        pack();
    thin();
}

void Checkpoints::pack() {
    const auto aim = static_cast<std::size_t>(kFilledAfterPacking * static_cast<double>(m_budget));
    const double allowed = kFreePackSeconds + kPackShare * m_kept.back().cutSeconds;
    const StopWatch watch;
    const double before = m_packSeconds;
    for (std::size_t index = 0; index + 1 < m_kept.size() && m_bytes > aim && m_packSeconds < allowed;
         ++index) {
        if (packOldest(index, m_bytes - aim) > 0)
            recount(index);
        m_packSeconds = before + watch.seconds();
    }
}

/// Packs tiles of one checkpoint that neither the checkpoint before nor the newest one has: tiles of the
/// newest are likely to be in use by the map, so that packing them would save nothing. Returns how many.
std::size_t Checkpoints::packOldest(std::size_t index, std::size_t wanted) {
    const Tiles& tiles = m_kept[index].tiles;
    const Tiles& newest = m_kept.back().tiles;
    std::size_t count = 0;
    std::size_t won = 0;
    for (std::size_t tile = 0; tile < tiles.size() && won < wanted; ++tile) {
        const std::shared_ptr<KeptTile>& kept = tiles[tile];
        const bool shared = index > 0 && m_kept[index - 1].tiles[tile] == kept;
        if (shared || kept->isPacked() || newest[tile] == kept)
            continue;
        kept->pack();
        won += sizeof(Tile) - std::min(sizeof(Tile), kept->bytes());
        ++count;
    }
    m_packedTiles += count;
    return count;
}

void Checkpoints::thin() {
    while (m_kept.size() > 1 && (m_bytes > m_budget || m_kept.size() > kMostCheckpoints)) {
        std::size_t victim = m_kept.size() - 1;
        double shortest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 1; k + 1 < m_kept.size(); ++k) {
            const double gap = m_kept[k + 1].cutSeconds - m_kept[k - 1].cutSeconds;
            if (gap < shortest) {
                shortest = gap;
                victim = k;
            }
        }
        m_bytes -= m_kept[victim].bytes;
        m_kept.erase(m_kept.begin() + static_cast<std::ptrdiff_t>(victim));
        recount(victim);
    }
}

} // namespace proveout
