// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/persistent_array.h"
#include "core/simulation/run/kept_tile.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Cutting time between two checkpoints. A step backward replays at most this much, and the decimation
/// period.
inline constexpr double kCheckpointSeconds = 0.01;

/// A snapshot from which the simulation can continue.
struct Checkpoint {
    std::size_t block = 0; ///< blocks executed
    ZMapSnapshot zmap;
    double removedMm3 = 0; ///< since the uncut stock
    double cutSeconds = 0; ///< time spent cutting since the uncut stock
};

/// The checkpoints of one run, by block. Tiles shared by neighbours count once. If they exceed the budget,
/// the oldest tiles are packed, as long as that takes little time compared with the cutting; if that is not
/// enough, the checkpoint whose neighbours are closest in cutting time is removed, the older one first, so
/// that replays stay as short as the memory allows. Owned by one thread.
class Checkpoints {
public:
    /// Discards all checkpoints; `first` (block 0) is kept permanently.
    void restart(const Checkpoint& first);
    /// Adds a checkpoint, unless there is one for its block already.
    void add(const Checkpoint& checkpoint);
    /// Whether the last checkpoint before a block is long ago, in cutting time or in blocks.
    [[nodiscard]] bool isDue(std::size_t block, double cutSeconds, std::size_t farBlocks) const;
    /// Discards checkpoints after `block`.
    void truncate(std::size_t block);
    void setBudget(std::size_t bytes);
    /// False if the budget is 0: then a checkpoint is not worth its snapshot, because tiles are copied after
    /// a snapshot.
    [[nodiscard]] bool wanted() const { return m_budget > 0; }

    /// The newest checkpoint at or before `block`; packed tiles are unpacked for it.
    [[nodiscard]] Checkpoint before(std::size_t block) const;
    /// The values of before(), without its z-map.
    [[nodiscard]] std::size_t blockBefore(std::size_t block) const { return keptBefore(block).block; }
    [[nodiscard]] double cutSecondsBefore(std::size_t block) const { return keptBefore(block).cutSeconds; }
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }
    [[nodiscard]] std::size_t size() const { return m_kept.size(); }
    [[nodiscard]] std::size_t packedTiles() const { return m_packedTiles; } ///< since the start of the run

    static constexpr std::size_t kDefaultBudget = 1'000'000'000;

private:
    using Tiles = PersistentArray<std::shared_ptr<KeptTile>>;
    struct Kept {
        std::size_t block = 0;
        Tiles tiles;
        double removedMm3 = 0;
        double cutSeconds = 0;
        std::size_t bytes = 0; ///< of the tiles that it does not share with the checkpoint before
    };

    [[nodiscard]] const Kept& keptBefore(std::size_t block) const;
    [[nodiscard]] Tiles keep(const ZMapSnapshot& zmap, std::size_t index) const;
    void recount(std::size_t index);
    void fit();
    void pack();
    [[nodiscard]] std::size_t packOldest(std::size_t index, std::size_t wanted);
    void thin();

    StockBox m_stock;
    Grid m_grid;
    std::vector<Kept> m_kept; ///< by ascending block
    std::size_t m_bytes = 0;
    std::size_t m_budget = kDefaultBudget;
    double m_packSeconds = 0;
    std::size_t m_packedTiles = 0;
};

} // namespace proveout
