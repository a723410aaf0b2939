// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/simulation/run/frame.h"
#include "ui/plots/row_range.h"

namespace proveout {

/// The data that the plots are drawn from: everything measured for the program. Most ticks append some rows,
/// a run after a seek back replaces some, and loading a program replaces all of them.
class PlotHistory {
public:
    /// What differs from the previous update. The first of the rows is the number of rows if rows were only
    /// removed or nothing has changed.
    struct Changes {
        RowRange blocks;
        std::size_t firstFrame = 0;
        RowRange pictured; ///< the blocks with a different frame
        bool any = false;
    };
    /// Adopts the current rows. Frames that the session has dropped after a seek back stay until their blocks
    /// are played again (`playing`), because showing an earlier block measures nothing.
    [[nodiscard]] Changes update(const PersistentArray<BlockStatistics>& blocks,
                                 const std::vector<FrameStatistics>& frames, bool playing);
    /// Call it when the rows will be replaced, because program, stock or text is another one.
    void forgetFrames();

    [[nodiscard]] const PersistentArray<BlockStatistics>& blocks() const { return m_blocks; }
    [[nodiscard]] const std::vector<FrameStatistics>& frames() const { return m_frames; }

private:
    void add(const FrameStatistics& row, bool playing, Changes& changes);

    PersistentArray<BlockStatistics> m_blocks;
    std::vector<FrameStatistics> m_session; ///< as in the session at the last update
    std::vector<FrameStatistics> m_frames;  ///< including those that the session has dropped
    bool m_forgotten = false;               ///< m_frames was emptied since the last update
};

} // namespace proveout
