// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/schedule_trace.h"

#include <cmath>
#include <utility>

#include "core/decimation/regions/region_mesh.h"

namespace proveout {

ScheduleTrace::ScheduleTrace(const RegionGrid& grid, std::span<const int> periods,
                             std::vector<double> startFaces)
    : m_grid(grid), m_faces(std::move(startFaces)), m_touches(grid.regionCount(), 0) {
    const std::size_t regions = grid.regionCount();
    double made = 0;
    for (std::size_t region = 0; region < regions; ++region) {
        m_fullFaces.push_back(static_cast<double>(fullRegionFaces(grid, region)));
        made += m_faces[region];
    }
    for (const int value : periods) {
        Period period;
        period.period = value;
        period.regions.resize(regions);
        for (std::size_t region = 0; region < regions; ++region)
            period.regions[region].faces = m_faces[region];
        period.facesMade = made;
        period.count.moments = 1;
        period.count.startRegions = regions;
        period.count.regionsDecimated = regions;
        m_periods.push_back(std::move(period));
    }
}

void ScheduleTrace::block(std::span<const std::size_t> touched) {
    ++m_block;
    for (const std::size_t region : touched)
        ++m_touches[region];
    for (Period& period : m_periods) {
        for (const std::size_t region : touched)
            touch(period, region);
        if (period.period > 0 && m_block % static_cast<std::uint32_t>(period.period) == 0)
            decimate(period);
        ++period.count.frames;
    }
}

/// Closes a period: the mesh of the region, or its points, was shown up to the frame before `until`.
void ScheduleTrace::close(Period& period, std::size_t region, std::uint32_t until) const {
    const Shown& shown = period.regions[region];
    const double frames = until - shown.since;
    if (shown.dirty)
        period.faces += frames * m_fullFaces[region];
    else if (shown.fresh)
        period.pending.push_back({region, shown.touches, frames, false});
    else
        period.faces += frames * shown.faces;
}

void ScheduleTrace::touch(Period& period, std::size_t region) const {
    Shown& shown = period.regions[region];
    if (shown.dirty)
        return;
    close(period, region, m_block);
    shown.dirty = true;
    shown.fresh = false;
    shown.since = m_block;
    period.dirty.push_back(region);
}

void ScheduleTrace::decimate(Period& period) {
    if (period.dirty.empty())
        return;
    ++period.count.moments;
    period.count.regionsDecimated += period.dirty.size();
    m_decimatedByAll += period.dirty.size();
    for (const std::size_t region : period.dirty) {
        close(period, region, m_block);
        Shown& shown = period.regions[region];
        shown = {false, true, m_block, m_touches[region], 0};
        period.pending.push_back({region, shown.touches, 0, true});
    }
    period.dirty.clear();
}

std::vector<std::size_t> ScheduleTrace::touchedSinceSample() const {
    std::vector<std::size_t> touched;
    for (std::size_t region = 0; region < m_touches.size(); ++region)
        if (m_touches[region] > 0)
            touched.push_back(region);
    return touched;
}

void ScheduleTrace::sample(std::span<const double> faces) {
    const std::vector<std::size_t> touched = touchedSinceSample();
    std::vector<double> now = m_faces;
    for (std::size_t k = 0; k < touched.size(); ++k)
        now[touched[k]] = faces[k];
    const auto between = [&](std::size_t region, std::uint32_t touches) {
        // A region that was dirty over the last sample and not touched since has the triangles of that
        // sample.
        const double share = m_touches[region] == 0 ? 0 : double(touches) / m_touches[region];
        return m_faces[region] + share * (now[region] - m_faces[region]);
    };
    for (Period& period : m_periods) {
        for (const Pending& pending : period.pending) {
            const double triangles = between(pending.region, pending.touches);
            period.faces += pending.frames * triangles;
            period.facesMade += pending.made ? triangles : 0;
        }
        period.pending.clear();
        for (std::size_t region = 0; region < period.regions.size(); ++region)
            if (Shown& shown = period.regions[region]; shown.fresh) {
                shown.faces = between(region, shown.touches);
                shown.fresh = false;
            }
    }
    m_faces = std::move(now);
    m_touches.assign(m_touches.size(), 0);
}

WorkCount ScheduleTrace::count(std::size_t k) const {
    Period period = m_periods[k];
    for (std::size_t region = 0; region < period.regions.size(); ++region)
        close(period, region, m_block + 1);
    period.count.regionsShown = period.count.frames * m_grid.regionCount();
    period.count.faces = static_cast<std::uint64_t>(std::llround(period.faces));
    period.count.facesMade = static_cast<std::uint64_t>(std::llround(period.facesMade));
    return period.count;
}

} // namespace proveout
