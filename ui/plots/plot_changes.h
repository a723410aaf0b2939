// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/simulation/run/frame.h"

namespace proveout {

/// What the plots are drawn from: all that was measured of the program. Most ticks append some rows, a run
/// after a seek back rewrites some, a load brings others.
class PlotHistory {
public:
    /// First rows that differ from the time before (or the number of rows, where some went away or none
    /// came).
    struct Changes {
        std::size_t firstBlock = 0;
        std::size_t firstFrame = 0;
        std::size_t firstPictured = 0; ///< the first block whose picture is another one
        bool any = false;
    };
    /// Takes over the present rows. Frames that the session no longer counts after a seek back stay until
    /// their blocks are played again (`playing`): a look at an earlier block measures nothing.
    [[nodiscard]] Changes update(const PersistentArray<BlockStatistics>& blocks,
                                 const std::vector<FrameStatistics>& frames, bool playing);
    /// Other rows are to come: of another program, stock or text.
    void forgetFrames();

    [[nodiscard]] const PersistentArray<BlockStatistics>& blocks() const { return m_blocks; }
    [[nodiscard]] const std::vector<FrameStatistics>& frames() const { return m_frames; }

private:
    void add(const FrameStatistics& row, bool playing, Changes& changes);

    PersistentArray<BlockStatistics> m_blocks;
    std::vector<FrameStatistics> m_session; ///< as the session had them at the last update
    std::vector<FrameStatistics> m_frames;  ///< with those that stay
    bool m_forgotten = false;               ///< m_frames was emptied since the last update
};

} // namespace proveout
