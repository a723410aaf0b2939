// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/file_allowance.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "core/base/figures_argument.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/formats/distinguished.h"
#include "core/formats/export_findings.h"

namespace proveout {

namespace {

/// The next mesh has other triangles on the walls, and its rounding may be larger.
constexpr double kMargin = 1.25;

/// How far rounding to single precision moves a coordinate between two bounds at most.
double roundingBetween(double low, double high) {
    const auto farthest = static_cast<float>(std::max(std::abs(low), std::abs(high)));
    const float next = std::nextafter(farthest, std::numeric_limits<float>::infinity());
    return (static_cast<double>(next) - static_cast<double>(farthest)) / 2;
}

/// How far it moves a surface vertically, on slopes of up to 45°.
double roundingOf(const StockBox& stock) {
    const Vec3& corner = stock.corner; // min X, min Y, top Z
    return roundingBetween(corner.x, corner.x + stock.width) +
           roundingBetween(corner.y, corner.y + stock.depth) +
           roundingBetween(corner.z - stock.height, corner.z);
}

/// Whether a file with such coordinates can be expected to keep the allowance, if the mesh is made for less.
bool isAffected(const DecimationParameters& promised, CoordinateType type) {
    return type != CoordinateType::float64 && row(promised.method).create != nullptr &&
           promised.allowance > 0 && isBounded(promised);
}

double halfOf(const DecimationParameters& promised) {
    return promised.allowance / 2;
}

/// With two digits that are not less than the value.
std::string roundedUp(double value) {
    const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
    return fmt::format("{:.6g}", std::ceil(value / digit) * digit);
}

/// `needed`: the allowance that would do, mm.
tl::unexpected<Diagnostics> refused(const FindingRow& row, const std::filesystem::path& file, double rounding,
                                    const DecimationParameters& promised, double needed) {
    return failure(row,
                   {figures("{}", distinguished(rounding, halfOf(promised))),
                    figures("{}", promised.allowance), figures("{}", roundedUp(needed)), exactMeshEndings()},
                   file.string());
}

} // namespace

FileAllowance::FileAllowance(const DecimationParameters& promised, CoordinateType type, const StockBox& stock)
    : m_promised(promised), m_parameters(promised), m_type(type) {
    if (isAffected(promised, type))
        m_parameters.allowance = std::max(promised.allowance - roundingOf(stock), halfOf(promised));
}

WorkContext FileAllowance::thisTry(const WorkContext& whole) const {
    constexpr double kRest = 0.1; // of what is left, for tries that are seldom needed
    return whole.part(1 - std::pow(kRest, m_tries - 1), 1 - std::pow(kRest, m_tries));
}

bool FileAllowance::reduce(SolidForExport& solid, const WorkContext& context) {
    if (!isAffected(m_promised, m_type) || solid.mesh().triangles.empty())
        return false;
    const double error = solid.largestErrorMm(m_type, context);
    const double excess = error - m_promised.allowance;
    if (context.stopped() || excess <= 0)
        return false;
    // Without rounding the solid is within the allowance that it was made for, except where touching parts
    // were set apart; that is the same for any allowance.
    const double setApart = solid.setApartErrorMm(context.quiet());
    const double rounding = error - std::max(m_parameters.allowance, setApart);
    const double least = halfOf(m_promised);
    if (context.stopped() || (setApart > m_promised.allowance && rounding <= least))
        return false;
    if (m_parameters.allowance <= least) {
        // Both together exceed the allowance, unless setting apart does so alone.
        const double beside = setApart > m_promised.allowance ? rounding : error - m_parameters.allowance;
        m_rounding = beside > least ? beside : 0;
        return false;
    }
    // Triangles of another mesh may be less steep, so that it is worth a try even if all looks lost.
    ++m_tries;
    m_step = std::max(kMargin * excess, 2 * m_step);
    const bool last = m_tries == kMostTries || rounding > least;
    m_parameters.allowance = last ? least : std::max(m_parameters.allowance - m_step, least);
    return true;
}

Result<void> FileAllowance::check(const std::filesystem::path& file, CoordinateType coordinates) const {
    if (m_rounding == 0 || coordinates == CoordinateType::float64)
        return {};
    return refused(export_finding::kExportWallsTooSteep, file, m_rounding, m_promised,
                   2 * kMargin * m_rounding);
}

Result<void> checkRounding(const std::filesystem::path& file, CoordinateType coordinates,
                           const DecimationParameters& promised, const StockBox& stock) {
    const double rounding = roundingOf(stock);
    if (!isAffected(promised, coordinates) || rounding <= halfOf(promised))
        return {};
    return refused(export_finding::kExportRoundingTooLarge, file, rounding, promised, 2 * rounding);
}

} // namespace proveout
