// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/solid_export.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <string>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/solid/solid_error.h"
#include "core/formats/export_findings.h"
#include "core/formats/mesh_writing.h"

namespace proveout {

namespace {

/// The share of measuring in the progress; writing takes longer.
constexpr double kMeasured = 0.3;

/// With the fewest digits that distinguish the value from the other one.
std::string distinguished(double value, double other) {
    constexpr int kFewest = 4;
    for (int digits = kFewest; digits < std::numeric_limits<double>::max_digits10; ++digits)
        if (std::string text = fmt::format("{:.{}g}", value, digits);
            text != fmt::format("{:.{}g}", other, digits))
            return text;
    return fmt::format("{}", value);
}

Diagnostic roundedBeyond(const std::filesystem::path& file, double rounded, double allowance, double exact) {
    Diagnostic warning =
        diagnosticOf(export_finding::kExportRoundedBeyond,
                     {figures("{}", distinguished(rounded, allowance)), figures("{}", allowance),
                      figures("{:.4g}", exact), exactMeshEndings()});
    warning.file = file.string();
    return warning;
}

/// How far rounding to single precision moves a coordinate between two bounds at most.
double roundingBetween(double low, double high) {
    const auto farthest = static_cast<float>(std::max(std::abs(low), std::abs(high)));
    const float next = std::nextafter(farthest, std::numeric_limits<float>::infinity());
    return (static_cast<double>(next) - static_cast<double>(farthest)) / 2;
}

} // namespace

DecimationParameters allowForRounding(DecimationParameters parameters, CoordinateType type,
                                      const StockBox& stock) {
    if (type == CoordinateType::float64 || !isBounded(parameters))
        return parameters;
    const Vec3& corner = stock.corner; // min X, min Y, top Z
    const double rounding = roundingBetween(corner.x, corner.x + stock.width) +
                            roundingBetween(corner.y, corner.y + stock.depth) +
                            roundingBetween(corner.z - stock.height, corner.z);
    parameters.allowance = std::max(parameters.allowance - rounding, parameters.allowance / 2);
    return parameters;
}

Result<ExportedSolid> exportSolid(const std::filesystem::path& file, const MeshFormat& format,
                                  const TriangleMesh& solid, const ZMapSnapshot& zmap, double allowance,
                                  ErrorLevel level, const WorkContext& context) {
    ExportedSolid exported;
    exported.largestErrorMm =
        measureSolidError(zmap, solid, format.coordinates, level, context.part(0, kMeasured));
    const bool rounded = format.coordinates != CoordinateType::float64;
    if (rounded && allowance > 0 && exported.largestErrorMm > allowance) {
        const double exact = measureSolidError(zmap, solid, CoordinateType::float64, level,
                                               context.part(kMeasured, kMeasured));
        if (exact <= allowance)
            exported.warnings.push_back(roundedBeyond(file, exported.largestErrorMm, allowance, exact));
    }
    auto written = format.write(file, solid, context.part(kMeasured, 1));
    if (!written)
        return tl::unexpected(std::move(written.error()));
    exported.file = *written;
    return exported;
}

} // namespace proveout
