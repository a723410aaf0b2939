// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that are cut while the surface of the blocks before them is still being made.
#pragma once

#include <cstddef>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/decimation/surface/surface.h"
#include "core/simulation/run/checkpoints.h"

namespace proveout {

/// Some blocks that have been cut one after the other, and what is needed to bring the surface to the last of
/// them.
struct CutStretch {
    struct Block {
        CutRecord record;
        double seconds = 0;               ///< of cutting
        std::vector<std::size_t> touched; ///< regions that were not dirty before it, ascending
    };
    /// A moment of the schedule, after one of the blocks.
    struct Moment {
        Checkpoint at;
        std::vector<std::size_t> regions; ///< all dirty ones, ascending
        std::vector<MadeRegion> made;     ///< by region
        std::vector<double> seconds;      ///< by region
    };
    /// One region at one moment.
    struct Job {
        std::size_t moment;
        std::size_t region;
    };

    std::vector<Block> blocks;
    std::vector<Moment> moments;
    std::vector<Job> jobs;
    std::size_t points = 0; ///< of the regions of all jobs
};

/// Which regions are dirty where the cutting is, ahead of the surface. Owned by one thread at a time.
class CutFront {
public:
    /// `dirty` regions differ from `base`, the heights at the last moment of the schedule.
    CutFront(const RegionGrid& grid, ZMapSnapshot base, const std::vector<std::size_t>& dirty);

    /// Adds a block that has been cut.
    void add(CutStretch& stretch, const ZMap& zmap, const CutRecord& record, double seconds);
    /// Adds a moment: all dirty regions are to be decimated with its heights.
    void addMoment(CutStretch& stretch, Checkpoint at);

private:
    RegionGrid m_grid;
    ZMapSnapshot m_base;
    std::vector<bool> m_isDirty; ///< by region
    std::vector<std::size_t> m_dirty;
};

} // namespace proveout
