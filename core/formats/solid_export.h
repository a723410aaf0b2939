// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/decimation/regions/parameters.h"
#include "core/formats/formats.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// A solid that was written, and how far what the file holds lies from the z-map.
struct ExportedSolid {
    WrittenFile file;
    double largestErrorMm = 0; ///< measureSolidError() of the coordinates in the file
    Diagnostics warnings;
};

/// Writes a solid of closeSolid(zmap, …) and measures what the file holds at the given level. A warning (id
/// "export-rounded-beyond") says where the rounding of coordinates, and not the decimation, has led beyond
/// the error allowance (mm; 0: none was given). Any thread. Errors: those of the writer, cancelled.
[[nodiscard]] Result<ExportedSolid> exportSolid(const std::filesystem::path& file, const MeshFormat& format,
                                                const TriangleMesh& solid, const ZMapSnapshot& zmap,
                                                double allowance, ErrorLevel level,
                                                const WorkContext& context = {});

} // namespace proveout
