// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimation/surface/surface.h"
#include "core/zmap/zmap.h"

namespace proveout::cli {

/// How far a surface lies from its z-map, and what that figure is worth.
struct MeasuredSurface {
    double largestErrorMm = 0;
    const char* level = "none"; ///< "surface", "sample", "measured" or "none"
};

/// Measures a surface anew from its triangles, without asking the decimator.
[[nodiscard]] MeasuredSurface measure(const SurfaceSnapshot& surface, const ZMapSnapshot& zmap,
                                      const DecimationParameters& parameters);

} // namespace proveout::cli
