// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/simulation/run/frame.h"
#include "core/simulation/run/statistics.h"

namespace proveout {

/// The part of a row for the blocks (first, last], which must be within the row; the mean per block stays the
/// same.
[[nodiscard]] FrameStatistics partOf(const FrameStatistics& row, std::uint32_t first, std::uint32_t last);

/// The cost of drawing: one row per drawn frame, ascending by lastBlock. Thread: the UI thread.
class FrameLog {
public:
    /// Clears the rows because another simulation starts.
    void clear();
    /// Records a drawn frame. False if this frame was recorded before, because a window is also repainted for
    /// other reasons. Drawing an earlier block removes the rows after it; continuing from there writes them
    /// again.
    bool add(const Frame& frame, double uploadSeconds, double drawSeconds);
    [[nodiscard]] const std::vector<FrameStatistics>& rows() const { return m_rows; }

private:
    std::vector<FrameStatistics> m_rows;
    std::size_t m_drawnBlock = 0;      ///< of the last drawn frame
    std::uint64_t m_drawnSequence = 0; ///< of the last drawn frame
};

} // namespace proveout
