// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measured_surface.h"

#include "core/decimation/regions/error_measure.h"

namespace proveout::cli {

MeasuredSurface measure(const SurfaceSnapshot& surface, const ZMapSnapshot& zmap,
                        const DecimationParameters& parameters) {
    if (surface.dirtyRegions == surface.grid.regionCount())
        return {};
    const std::vector<LatticeTriangle> triangles = surface.triangles();
    if (errorLevel(parameters) == ErrorLevel::surface)
        return {measureSurfaceError(zmap, triangles), "surface"};
    const IndexRect all{0, 0, zmap.grid().nx, zmap.grid().ny};
    const auto error = measureVerticalError(zmap, all, triangles, parameters.allowance);
    return {error.largest, isBounded(parameters) ? "sample" : "measured"};
}

} // namespace proveout::cli
