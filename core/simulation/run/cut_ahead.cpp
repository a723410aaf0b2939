// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/cut_ahead.h"

#include <algorithm>
#include <utility>

#include "core/simulation/run/changed_regions.h"

namespace proveout {

CutFront::CutFront(const RegionGrid& grid, ZMapSnapshot base, const std::vector<std::size_t>& dirty)
    : m_grid(grid), m_base(std::move(base)), m_isDirty(grid.regionCount(), false), m_dirty(dirty) {
    for (const std::size_t region : m_dirty)
        m_isDirty[region] = true;
}

void CutFront::add(CutStretch& stretch, const ZMap& zmap, const CutRecord& record, double seconds) {
    CutStretch::Block block{record, seconds, {}};
    forChangedRegions(
        zmap, m_base, record.changed, m_grid, [&](std::size_t region) { return m_isDirty[region]; },
        [&](std::size_t region) {
            m_isDirty[region] = true;
            m_dirty.push_back(region);
            block.touched.push_back(region);
        });
    stretch.blocks.push_back(std::move(block));
}

void CutFront::addMoment(CutStretch& stretch, Checkpoint at) {
    std::sort(m_dirty.begin(), m_dirty.end());
    for (std::size_t k = 0; k < m_dirty.size(); ++k) {
        m_isDirty[m_dirty[k]] = false;
        stretch.jobs.push_back({stretch.moments.size(), k});
        const IndexRect points = m_grid.points(m_dirty[k]);
        stretch.points +=
            static_cast<std::size_t>(points.width()) * static_cast<std::size_t>(points.height());
    }
    m_base = at.zmap;
    CutStretch::Moment moment{std::move(at), std::exchange(m_dirty, {}), {}, {}};
    moment.made.resize(moment.regions.size());
    moment.seconds.resize(moment.regions.size());
    stretch.moments.push_back(std::move(moment));
}

} // namespace proveout
