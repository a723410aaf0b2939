// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/map_memory.h"

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/decimation/refined_surface.h"
#include "core/decimation/region_decimator.h"

namespace proveout {

namespace {

// Measured: peaks of runs on maps of noise, of which no triangle can be removed.
constexpr double kFullSurface = 25;
constexpr double kLayer = 25;  ///< each time that regions are merged: what they were made of is kept
constexpr double kListed = 30; ///< all triangles once more, to be measured or closed
constexpr double kSolid = 60;
constexpr double kAgain = 13; ///< two maps and 4 bytes a mark
/// A region with its borders and its places in arrays, whatever the triangles; measured on planes.
constexpr double kRegion = 500;

bool decimates(const DecimationParameters& parameters) {
    return row(parameters.method).create != nullptr && parameters.allowance > 0;
}

double pointsOf(const Grid& grid) {
    return static_cast<double>(grid.nx) * grid.ny;
}

bool makesRegions(const DecimationParameters& parameters, const MapOutputs& outputs) {
    return decimates(parameters) && (outputs.whole || (outputs.schedule && parameters.period != 0));
}

/// How often regions are merged until blocks of them have so many cells along a side.
int layers(int cells, int mostCells) {
    int count = 0;
    for (; 2 * cells <= mostCells; cells *= 2)
        ++count;
    return count;
}

/// Of the regions by themselves.
double regionBytesPerPoint(const DecimationParameters& parameters) {
    const DecimationMethodRow& method = row(parameters.method);
    if (method.wholeMap)
        return method.bytesPerPoint;
    return method.bytesPerPoint + kRegion / (parameters.regionCells * parameters.regionCells);
}

} // namespace

double meshBytesPerPoint(const DecimationParameters& parameters, const MapOutputs& outputs) {
    double bytes = outputs.solid ? kSolid : 0;
    if (makesRegions(parameters, outputs))
        bytes += regionBytesPerPoint(parameters);
    if (decimates(parameters) && outputs.whole) {
        bytes += kListed;
        if (canMerge(parameters)) // beside the regions of the schedule, which are others
            bytes += layers(parameters.regionCells, kMostExportCells) * kLayer +
                     (outputs.schedule ? regionBytesPerPoint(parameters) : 0);
    }
    if (outputs.fullMesh || (outputs.solid && !decimates(parameters)))
        bytes += kFullSurface;
    if (outputs.again)
        bytes += kAgain;
    return bytes;
}

Result<void> checkMapMemory(const StockBox& stock, const Grid& grid, const DecimationParameters& parameters,
                            const MapOutputs& outputs, double limitBytes) {
    const double points = pointsOf(grid);
    const double most = row(parameters.method).mostPoints;
    if (makesRegions(parameters, outputs) && points > most)
        return failure("method-map-too-large",
                       PROVEOUT_TEXT("Core", "The method “{}” works on maps of {} points at most; this "
                                             "one has {}."),
                       {kMethodChoices[static_cast<std::size_t>(parameters.method)].key,
                        fmt::format("{:.0f}", most), fmt::format("{:.0f}", points)});
    return checkMemory(stock, grid, limitBytes, meshBytesPerPoint(parameters, outputs));
}

double bytesAtRest(const DecimationParameters& parameters, const Grid& grid, std::size_t faces) {
    constexpr double kWorkers = 32e6;
    constexpr double kFace = 12.5;
    // Everywhere instead of at the points: at most so many faces more were seen, on steep walls.
    constexpr double kMoreFaces = 1.4;
    const double regions = pointsOf(grid) / (parameters.regionCells * parameters.regionCells);
    const int meshes = 1 + layers(parameters.regionCells, RefinedSurface::kMostCells);
    return kWorkers + 3 * kRegion * regions + static_cast<double>(faces) * kMoreFaces * kFace * meshes;
}

} // namespace proveout
