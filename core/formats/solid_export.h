// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/decimation/regions/parameters.h"
#include "core/decimation/solid/solid.h"
#include "core/formats/formats.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// A solid for mesh files, and how far it is from its z-map in the coordinates of a file, which is measured
/// once for each type of coordinates, when it is first needed. Refers to the z-map. One thread at a time.
class SolidForExport {
public:
    /// `mesh`: of closeSolid(zmap, …). `level`: where it is measured.
    SolidForExport(const ZMapSnapshot& zmap, TriangleMesh mesh, ErrorLevel level);
    /// `solid`: of closeWithWalls(zmap, …) for such coordinates, and what was promised for this level.
    SolidForExport(const ZMapSnapshot& zmap, WalledSolid solid, ErrorLevel level, CoordinateType coordinates);

    [[nodiscard]] const ZMapSnapshot& zmap() const { return *m_zmap; }
    [[nodiscard]] const TriangleMesh& mesh() const { return m_mesh; }
    /// How many points the map had beside walls before the solid was closed: closeWithWalls() may draw some
    /// of them at the points of the grid.
    void setWallPoints(std::size_t count) { m_wallPoints = count; }
    [[nodiscard]] std::size_t wallPoints() const { return m_wallPoints; }
    [[nodiscard]] std::size_t wallPointsOnGrid() const;
    /// measureSolidError(), mm. A stopped context returns early, with a part of the result.
    [[nodiscard]] double largestErrorMm(CoordinateType type, const WorkContext& context = {});
    /// The same in double precision if touching parts of the solid were set apart, else 0: what exceeds the
    /// allowance of a bounded method there does so because of that.
    [[nodiscard]] double setApartErrorMm(const WorkContext& context = {});

private:
    const ZMapSnapshot* m_zmap;
    TriangleMesh m_mesh;
    ErrorLevel m_level;
    std::size_t m_wallPoints = 0;
    std::array<std::optional<double>, 2> m_errors; ///< by CoordinateType
};

/// A solid that was written, and how far the contents of the file deviate from the z-map.
struct ExportedSolid {
    WrittenFile file;
    double largestErrorMm = 0; ///< measureSolidError() of the coordinates in the file
    Diagnostics warnings;
};

/// Writes a solid and measures the contents of the file. Warnings report that its error exceeds the allowance
/// of `promised` (0: there is none) because of the rounding of coordinates (id "export-rounded-beyond"), or,
/// if the method is bounded, because of parts that were set apart (id "export-set-apart"). A note reports
/// walls that are at points of the grid (id "export-walls-on-grid", "export-walls-unknown"),
/// and ribs that it does not have (id "export-ribs-unseen"). Any thread.
/// Errors: those of the writer, cancelled.
[[nodiscard]] Result<ExportedSolid> exportSolid(const std::filesystem::path& file, const MeshFormat& format,
                                                SolidForExport& solid, const DecimationParameters& promised,
                                                const WorkContext& context = {});

} // namespace proveout
