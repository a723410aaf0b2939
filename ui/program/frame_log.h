// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/simulation/run/frame.h"
#include "core/simulation/run/statistics.h"

namespace proveout {

/// What is left of a row for the blocks (first, last] of its own: the mean of a block stays.
[[nodiscard]] FrameStatistics partOf(const FrameStatistics& row, std::uint32_t first, std::uint32_t last);

/// What drawing cost: one row per frame that was drawn, ascending by lastBlock. Thread: the UI thread.
class FrameLog {
public:
    /// Forgets the rows: another simulation begins.
    void clear();
    /// Notes a drawn frame. False where this very frame was noted before: a window is painted for other
    /// reasons too. Going back cuts the rows off behind the block when it is drawn; going on from there
    /// writes them anew.
    bool add(const Frame& frame, double uploadSeconds, double drawSeconds);
    [[nodiscard]] const std::vector<FrameStatistics>& rows() const { return m_rows; }

private:
    std::vector<FrameStatistics> m_rows;
    std::size_t m_drawnBlock = 0;      ///< of the frame drawn last
    std::uint64_t m_drawnSequence = 0; ///< of the frame drawn last
};

} // namespace proveout
