// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <random>
#include <span>
#include <stop_token>
#include <vector>

#include "core/decimation/surface/surface.h"
#include "core/study/cost_model.h"
#include "core/study/region_faces.h"
#include "core/study/schedule_trace.h"

namespace proveout {

/// One region size in a rehearsal: the trace of its schedules, and a surface of which some regions are
/// decimated and measured. Owned by one thread.
class RehearsedRegions {
public:
    /// Decimates some regions of the uncut stock, or all of them if the surface is to be drawn. After a stop
    /// the object can only be destroyed.
    RehearsedRegions(const ZMapSnapshot& uncut, const DecimationParameters& parameters,
                     std::span<const int> periods, bool all, const std::stop_token& stop);

    /// Call it after each block: the two snapshots differ at most within `changed`.
    void block(const ZMapSnapshot& before, const ZMapSnapshot& after, const IndexRect& changed);
    /// Decimates regions that were touched since the last sample and measures the time: some chosen at random
    /// together, as a long period would, and those of the last block together, as a short period would. The
    /// triangles of the others are estimated from `reference`, which has been sampled at this moment; the
    /// reference itself (null) decimates all. Returns how many triangles were made.
    std::size_t sample(const ZMapSnapshot& now, const RehearsedRegions* reference);

    [[nodiscard]] SurfaceSnapshot surface() const { return m_surface.snapshot(); }
    [[nodiscard]] const DecimationParameters& parameters() const { return m_surface.parameters(); }
    [[nodiscard]] WorkCount count(std::size_t period) const { return m_trace.count(period); }
    /// The measurements, by moments, regions and triangles made.
    [[nodiscard]] std::span<const CostSample> samples() const { return m_samples; }
    /// The coefficients of this size; adds what they do not explain to `slowdown`.
    [[nodiscard]] CostModel::Decimation fitted(Slowdown& slowdown) const;

private:
    [[nodiscard]] static Surface startSurface(const ZMapSnapshot& uncut,
                                              const DecimationParameters& parameters, bool all,
                                              const std::stop_token& stop, double& perRegion);
    /// How many regions may be decimated now; at least one.
    [[nodiscard]] std::size_t affordable() const;
    void measure(std::span<const std::size_t> regions, const ZMapSnapshot& now);

    double m_perStartRegion = 0; ///< seconds
    Surface m_surface;
    RegionFaces m_faces;
    ScheduleTrace m_trace;
    std::size_t m_sampled = 0;              ///< regions decimated in samples
    std::vector<std::size_t> m_lastTouched; ///< by the last block
    std::vector<CostSample> m_samples;      ///< moments, regions, triangles made
    std::mt19937 m_random{1};               ///< chooses the regions that are sampled; the same in every
                                            ///< rehearsal
};

} // namespace proveout
