// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/surface_at_rest.h"

#include <utility>
#include <vector>

#include "core/base/memory.h"
#include "core/decimation/surface/map_memory.h"
#include "core/simulation/run/changed_regions.h"
#include "core/simulation/run/frame.h"

namespace proveout {

void SurfaceAtRest::follow(const Frame& moment, RimFinder& rims, std::size_t faces,
                           const WorkContext& context) {
    const DecimationParameters& parameters = moment.parameters;
    const double needed = bytesAtRest(parameters, moment.zmap.grid(), faces);
    if (needed - m_bytes > static_cast<double>(memoryLimitBytes())) {
        *this = {};
        m_fits = false;
        return;
    }
    m_bytes = needed;
    ZMapSnapshot now = rims.find(moment, context.quiet());
    std::vector<std::size_t> changed;
    if (m_zmap)
        changed = differingRegions(*m_zmap, now, m_surface.grid());
    else
        m_surface = RefinedSurface(now.grid().nx, now.grid().ny, parameters);
    m_zmap = std::move(now);
    m_isShown = m_surface.follow(*m_zmap, changed, context);
}

void SurfaceAtRest::outdate() {
    m_isShown = false;
    m_fits = true;
}

} // namespace proveout
