// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "core/simulation/run/block_rows.h"
#include "core/simulation/run/block_set.h"
#include "core/simulation/run/removed_volume.h"

namespace proveout {

/// Which blocks of a run get records: all, until it is told otherwise. Value type.
class KeptRecords {
public:
    /// Only these from now on. The first call is made before anything is cut, with the uncut map.
    void keepOnly(BlockSet blocks, const ZMap& map) {
        if (!m_volume)
            m_volume.emplace(map);
        m_blocks = std::move(blocks);
    }

    /// Null: all.
    [[nodiscard]] const BlockSet* blocks() const { return m_blocks ? &*m_blocks : nullptr; }
    /// The row of a block that was cut with these records.
    [[nodiscard]] BlockStatistics row(std::size_t block, const CutRecord& record,
                                      std::size_t facesFull) const {
        return !m_blocks || m_blocks->contains(block) ? recordedRow(record, facesFull)
                                                      : unrecordedRow(facesFull);
    }
    /// What was removed; `byRecords` is the sum of the records.
    [[nodiscard]] double removedMm3(const ZMap& map, double byRecords) const {
        return m_volume ? m_volume->removedFrom(map) : byRecords;
    }

private:
    std::optional<BlockSet> m_blocks;
    std::optional<RemovedVolume> m_volume;
};

} // namespace proveout
