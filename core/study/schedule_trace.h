// SPDX-License-Identifier: GPL-3.0-or-later
// The work of every period with the regions of one size, determined without decimating.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/decimation/regions/region_grid.h"
#include "core/study/study_run.h"

namespace proveout {

/// Follows one run of the cutting and records, for every period at once, which regions are dirty. Frames,
/// moments and regions are counted exactly as in a run with that period. Triangles are exact where a region
/// is drawn from the z-map (except at its border to a decimated neighbour); those of decimated regions are
/// sampled now and then by the caller, and between two samples are assumed to change by the same amount with
/// each touch. Owned by one thread.
class ScheduleTrace {
public:
    /// `periods`: as in DecimationParameters, without 0. `startFaces`: triangles of each region after the
    /// start.
    ScheduleTrace(const RegionGrid& grid, std::span<const int> periods, std::vector<double> startFaces);

    [[nodiscard]] const RegionGrid& grid() const { return m_grid; }
    /// Call it after each block, with the regions whose points it lowered.
    void block(std::span<const std::size_t> touched);
    /// Regions touched since the last sample, ascending.
    [[nodiscard]] std::vector<std::size_t> touchedSinceSample() const;
    /// Sets the triangles of regions that are decimated now: one value for each of touchedSinceSample().
    void sample(std::span<const double> faces);
    /// Regions that the schedules of all periods together have decimated since the start.
    [[nodiscard]] std::uint64_t decimatedByAll() const { return m_decimatedByAll; }
    /// The work of a run with periods[k], after all blocks and a last sample().
    [[nodiscard]] WorkCount count(std::size_t k) const;

private:
    /// The state of one region under one period.
    struct Shown {
        bool dirty = false;
        bool fresh = false;        ///< decimated since the last sample: its triangles are not known yet
        std::uint32_t since = 1;   ///< first frame with this state
        std::uint32_t touches = 0; ///< of the region since the last sample, when it was decimated
        double faces = 0;          ///< of its mesh, if known
    };
    /// Frames that showed a mesh whose triangles are not known yet.
    struct Pending {
        std::size_t region;
        std::uint32_t touches;
        double frames; ///< 0: only the making of the mesh counts
        bool made;
    };
    struct Period {
        int period = 0;
        std::vector<Shown> regions;
        std::vector<std::size_t> dirty;
        std::vector<Pending> pending;
        WorkCount count;
        double faces = 0;
        double facesMade = 0;
    };

    void touch(Period& period, std::size_t region) const;
    void decimate(Period& period);
    void close(Period& period, std::size_t region, std::uint32_t until) const;

    RegionGrid m_grid;
    std::vector<Period> m_periods;
    std::vector<double> m_fullFaces;
    std::vector<double> m_faces;          ///< at the last sample
    std::vector<std::uint32_t> m_touches; ///< since the last sample
    std::uint32_t m_block = 0;
    std::uint64_t m_decimatedByAll = 0;
};

} // namespace proveout
