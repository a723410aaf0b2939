// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/solid_export.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/solid/solid_error.h"
#include "core/formats/distinguished.h"
#include "core/formats/export_findings.h"
#include "core/formats/mesh_writing.h"

namespace proveout {

namespace {

/// The share of measuring in the progress; writing takes longer.
constexpr double kMeasured = 0.3;

Diagnostic roundedBeyond(double rounded, double allowance, double exact) {
    return diagnosticOf(export_finding::kExportRoundedBeyond,
                        {figures("{}", distinguished(rounded, allowance)), figures("{}", allowance),
                         figures("{:.4g}", exact), exactMeshEndings()});
}

Diagnostic setApart(double error, double allowance) {
    return diagnosticOf(export_finding::kExportSetApart,
                        {figures("{}", distinguished(error, allowance)), figures("{}", allowance)});
}

/// Why the error of a file exceeds the allowance, if it does so for another reason than the decimation.
Diagnostics warningsOf(SolidForExport& solid, CoordinateType type, const DecimationParameters& promised,
                       const WorkContext& context) {
    const double allowance = promised.allowance;
    const double error = solid.largestErrorMm(type);
    if (allowance <= 0 || error <= allowance)
        return {};
    if (isBounded(promised) && solid.setApartErrorMm(context) > allowance)
        return {setApart(error, allowance)};
    if (type == CoordinateType::float64)
        return {};
    const double exact = solid.largestErrorMm(CoordinateType::float64, context);
    if (exact > allowance)
        return {};
    return {roundedBeyond(error, allowance, exact)};
}

/// The middle of the first edge that a rib crosses unseen.
std::optional<Vec2> firstUnseenRib(const ZMapSnapshot& zmap) {
    for (std::size_t tile = 0; tile < zmap.rims().size(); ++tile) {
        const RimTilePtr& rims = zmap.rims()[tile];
        if (rims == nullptr || rims->unseenRibs.empty())
            continue;
        const Grid& grid = zmap.grid();
        const RimEdge edge = RimEdge::of(rims->unseenRibs.front());
        const IndexRect rect = zmap.tileRect(tile);
        return Vec2(grid.x(rect.i0 + edge.i) + (edge.alongY ? 0 : grid.hx / 2),
                    grid.y(rect.j0 + edge.j) + (edge.alongY ? grid.hy / 2 : 0));
    }
    return std::nullopt;
}

} // namespace

SolidForExport::SolidForExport(const ZMapSnapshot& zmap, TriangleMesh mesh, ErrorLevel level)
    : m_zmap(&zmap), m_mesh(std::move(mesh)), m_level(level) {}

SolidForExport::SolidForExport(const ZMapSnapshot& zmap, WalledSolid solid, ErrorLevel level,
                               CoordinateType coordinates)
    : SolidForExport(zmap, std::move(solid.mesh), level) {
    m_errors.at(static_cast<std::size_t>(coordinates)) = solid.largestErrorMm;
}

double SolidForExport::largestErrorMm(CoordinateType type, const WorkContext& context) {
    std::optional<double>& known = m_errors.at(static_cast<std::size_t>(type));
    if (known)
        return *known;
    const double error = measureSolidError(*m_zmap, m_mesh, type, m_level, context);
    if (!context.stopped())
        known = error;
    return error;
}

std::size_t SolidForExport::wallPointsOnGrid() const {
    return m_wallPoints - std::min(m_zmap->walls().count(), m_wallPoints);
}

double SolidForExport::setApartErrorMm(const WorkContext& context) {
    return hasVerticesSetApart(*m_zmap, m_mesh) ? largestErrorMm(CoordinateType::float64, context) : 0;
}

Result<ExportedSolid> exportSolid(const std::filesystem::path& file, const MeshFormat& format,
                                  SolidForExport& solid, const DecimationParameters& promised,
                                  const WorkContext& context) {
    ExportedSolid exported;
    exported.largestErrorMm = solid.largestErrorMm(format.coordinates, context.part(0, kMeasured));
    if (!context.stopped())
        exported.warnings = warningsOf(solid, format.coordinates, promised, context.quiet());
    if (solid.wallPointsOnGrid() > 0)
        exported.warnings.push_back(
            diagnosticOf(export_finding::kExportWallsOnGrid,
                         {std::to_string(solid.wallPointsOnGrid()), std::to_string(solid.wallPoints())}));
    if (const std::size_t unknown = unknownTiles(solid.zmap().rims()); unknown > 0)
        exported.warnings.push_back(
            diagnosticOf(export_finding::kExportWallsUnknown,
                         {std::to_string(unknown), std::to_string(solid.zmap().tileCount()),
                          std::to_string(kMostMotionsOfRims)}));
    if (const auto first = firstUnseenRib(solid.zmap()))
        exported.warnings.push_back(diagnosticOf(export_finding::kExportRibsUnseen,
                                                 {std::to_string(unseenRibs(solid.zmap().rims())),
                                                  figures("{:.3f}", first->x), figures("{:.3f}", first->y)}));
    for (Diagnostic& warning : exported.warnings)
        warning.file = file.string();
    auto written = format.write(file, solid.mesh(), context.part(kMeasured, 1));
    if (!written)
        return tl::unexpected(std::move(written.error()));
    exported.file = *written;
    return exported;
}

} // namespace proveout
