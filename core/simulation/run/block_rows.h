// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cutting/cut/cutting.h"
#include "core/simulation/run/statistics.h"

namespace proveout {

/// Adds what was recorded of the block of a row.
inline void addRecord(BlockStatistics& row, const CutRecord& record) {
    row.removedMm3 = record.removedMm3;
    row.maxDepth = static_cast<float>(record.maxDepth);
    row.radialEngagement = static_cast<float>(record.radialEngagement());
}

/// What is known of a block that was cut, without the times and the surface. `facesFull`: of the map.
[[nodiscard]] inline BlockStatistics recordedRow(const CutRecord& record, std::size_t facesFull) {
    BlockStatistics row;
    row.facesFull = static_cast<std::uint32_t>(facesFull);
    addRecord(row, record);
    return row;
}

/// The same without a record.
[[nodiscard]] inline BlockStatistics unrecordedRow(std::size_t facesFull) {
    BlockStatistics row;
    row.facesFull = static_cast<std::uint32_t>(facesFull);
    row.removedMm3 = BlockStatistics::kNotMeasured;
    row.maxDepth = BlockStatistics::kNotMeasured;
    row.radialEngagement = BlockStatistics::kNotMeasured;
    return row;
}

} // namespace proveout
