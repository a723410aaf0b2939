// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/decimation/regions/parameters.h"
#include "core/formats/formats.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// A solid that was written, and how far the contents of the file deviate from the z-map.
struct ExportedSolid {
    WrittenFile file;
    double largestErrorMm = 0; ///< measureSolidError() of the coordinates in the file
    Diagnostics warnings;
};

/// The parameters for a surface that is within the allowance in a file with such coordinates: a bounded
/// method gets the allowance less what rounding adds on slopes of up to 45°, but at least half of it.
[[nodiscard]] DecimationParameters allowForRounding(DecimationParameters parameters, CoordinateType type,
                                                    const StockBox& stock);

/// Writes a solid of closeSolid(zmap, …) and measures the contents of the file at the given level. A warning
/// (id "export-rounded-beyond") reports when the error exceeds the allowance (mm; 0: none was given) because
/// of the rounding of coordinates rather than the decimation. Any thread. Errors: those of the writer,
/// cancelled.
[[nodiscard]] Result<ExportedSolid> exportSolid(const std::filesystem::path& file, const MeshFormat& format,
                                                const TriangleMesh& solid, const ZMapSnapshot& zmap,
                                                double allowance, ErrorLevel level,
                                                const WorkContext& context = {});

} // namespace proveout
