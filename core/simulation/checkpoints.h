// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/zmap/zmap.h"

namespace proveout {

/// A moment from which the simulation can go on.
struct Checkpoint {
    std::size_t block = 0; ///< blocks executed
    ZMapSnapshot zmap;
    double removedMm3 = 0; ///< since the uncut stock
    double cutSeconds = 0; ///< time spent cutting since the uncut stock
    std::size_t bytes = 0; ///< of the tiles that the checkpoint before does not share
};

/// The checkpoints of one run, by block. Tiles shared by neighbours count once. Where they outgrow the budget
/// the checkpoint goes whose neighbours are closest in cutting time, the older one first, so that replays
/// stay as short as the memory allows. Owned by one thread.
class Checkpoints {
public:
    /// Forgets all; `first` (block 0) is kept for ever.
    void restart(Checkpoint first);
    /// Takes a checkpoint, or leaves the one that exists for its block.
    void add(Checkpoint checkpoint);
    /// Forgets checkpoints behind `block`.
    void truncate(std::size_t block);
    void setBudget(std::size_t bytes);
    /// False where the budget is 0: then a moment is not worth its snapshot, after which tiles are copied.
    [[nodiscard]] bool wanted() const { return m_budget > 0; }

    /// The newest checkpoint at or before `block`. Valid until the next change.
    [[nodiscard]] const Checkpoint& before(std::size_t block) const;
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }
    [[nodiscard]] std::size_t size() const { return m_checkpoints.size(); }

    static constexpr std::size_t kStandardBudget = 1'000'000'000;

private:
    void recount(std::size_t index);
    void thin();

    std::vector<Checkpoint> m_checkpoints; ///< ascending blocks
    std::size_t m_bytes = 0;
    std::size_t m_budget = kStandardBudget;
};

} // namespace proveout
