// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimation/surface/surface.h"
#include "core/zmap/zmap.h"

namespace proveout::cli {

/// The deviation of a surface from its z-map, and how it was determined.
struct MeasuredSurface {
    double largestErrorMm = 0;
    const char* level = "none"; ///< "surface", "sample", "measured" or "none"
};

/// Measures a surface from its triangles, independently of the decimator.
[[nodiscard]] MeasuredSurface measure(const SurfaceSnapshot& surface, const ZMapSnapshot& zmap,
                                      const DecimationParameters& parameters);

} // namespace proveout::cli
