// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_pictures.h"

#include <algorithm>
#include <utility>

#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/solid/solid.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/formats/glb.h"
#include "core/report/map_picture.h"

namespace proveout {

namespace {

/// More triangles make a page that no mail carries.
constexpr std::size_t kMostTriangles = 400'000;
/// The error allowance of the first attempt, as a part of the smaller tolerance.
constexpr double kPartOfTolerance = 0.25;
constexpr double kLeastAllowance = 0.005; // mm
constexpr int kAttempts = 4;

struct Solid {
    TriangleMesh mesh;
    double errorMm = 0;
};

std::optional<Solid> solidOf(ZMapSnapshot stock, double allowance, const WorkContext& context) {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::certified;
    parameters.allowance = allowance;
    parameters.regionCells = defaultRegion(parameters.method, static_cast<double>(stock.grid().nx) *
                                                                  static_cast<double>(stock.grid().ny));
    const SurfaceSnapshot surface = decimatedWhole(stock, forExport(parameters), context);
    if (surface.faces > kMostTriangles)
        return std::nullopt;
    auto solid = closeWithWalls(stock, surface.triangles(), parameters, CoordinateType::float32, context);
    if (!solid || solid->mesh.triangles.empty())
        return std::nullopt;
    return Solid{std::move(solid->mesh), solid->largestErrorMm.value_or(allowance)};
}

} // namespace

ReportPictures reportPictures(const ZMapSnapshot& stock, const PartComparison* comparison,
                              const WorkContext& context) {
    ReportPictures pictures;
    pictures.stockPng = pngOf(stockPicture(stock));
    if (comparison == nullptr)
        return pictures;
    const PartTolerance& tolerance = comparison->tolerance;
    pictures.deviationPng = pngOf(deviationPicture(comparison->deviation, tolerance, Shading::lit));
    double allowance =
        std::max(kLeastAllowance, kPartOfTolerance * std::min(tolerance.below, tolerance.above));
    for (int attempt = 0; attempt < kAttempts && !context.stopped(); ++attempt, allowance *= 4) {
        const auto solid = solidOf(comparison->deviation.stock(), allowance, context);
        if (!solid)
            continue;
        const Grid& grid = stock.grid();
        const Vec2 half(grid.hx / 2, grid.hy / 2);
        const PlanTexture texture{pngOf(deviationPicture(comparison->deviation, tolerance, Shading::none)),
                                  Vec2(grid.x(0), grid.y(0)) - half,
                                  Vec2(grid.x(grid.nx - 1), grid.y(grid.ny - 1)) + half};
        if (auto glb = glbOf(solid->mesh, texture)) {
            pictures.glb = std::move(*glb);
            pictures.glbErrorMm = solid->errorMm;
        }
        break;
    }
    return pictures;
}

} // namespace proveout
