// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/surface/map_memory.h"

#include <algorithm>
#include <fmt/format.h>

#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/surface/decimation_findings.h"
#include "core/decimation/surface/refined_surface.h"

namespace proveout {

namespace {

// Bytes per point. Measured: peaks of runs on maps of noise, in which no triangle can be removed, and on maps
// that reach the floor at every other point (tests/bench/memory_table).
constexpr double kLayer = 25;        ///< for each merge of regions: the meshes that were merged are kept
constexpr double kMeasured = 30;     ///< all triangles a second time, and the distances of the points
constexpr double kSolid = 135;       ///< including the list of triangles that becomes its own
constexpr double kWalledSolid = 270; ///< the same, closed with walls, which keeps the surface meanwhile
constexpr double kAgain = 13;        ///< two maps and 4 bytes per mark
constexpr double kMachined = 12; ///< all of that for a machined surface: 10 to 12 in the runs of whole_run
constexpr double kMap = 4.1;     ///< another map, in tiles
/// A region with its borders and its entries in arrays, without triangles; measured on planes.
constexpr double kRegion = 500;
constexpr double kFacesPerPoint = 2; ///< without decimation
// For each rim.
constexpr double kRim = 100;        ///< with the wall points on both sides
constexpr double kRimOfSolid = 700; ///< while a solid is closed with them
// Rims per point of the grid: of holes of two and a half cells side by side, and of parts whose walls are
// farther apart than a hundred cells.
constexpr double kMostRims = 0.6;
constexpr double kMachinedRims = 0.01;

bool decimates(const DecimationParameters& parameters) {
    return row(parameters.method).create != nullptr && parameters.allowance > 0;
}

double pointsOf(const Grid& grid) {
    return static_cast<double>(grid.nx) * grid.ny;
}

bool followsSchedule(const DecimationParameters& parameters, const MapOutputs& outputs) {
    return decimates(parameters) && outputs.schedule && parameters.period != 0;
}

bool decimatesWhole(const DecimationParameters& parameters, const MapOutputs& outputs) {
    return decimates(parameters) && outputs.whole;
}

/// How often regions are merged until blocks of them have this many cells along a side.
int layers(int cells, int mostCells) {
    int count = 0;
    for (; 2 * cells <= mostCells; cells *= 2)
        ++count;
    return count;
}

/// Of regions without triangles.
double emptyRegionBytesPerPoint(const DecimationParameters& parameters) {
    return kRegion / (parameters.regionCells * parameters.regionCells);
}

/// For the regions alone, and while they are made.
double regionBytesPerPoint(const DecimationParameters& parameters) {
    const DecimationMethodRow& method = row(parameters.method);
    return method.bytesPerPoint + (method.wholeMap ? 0 : emptyRegionBytesPerPoint(parameters));
}

/// The maps beside the one that is cut.
double mapsBytesPerPoint(const DecimationParameters& parameters, const MapOutputs& outputs) {
    return (followsSchedule(parameters, outputs) || outputs.shown ? kMap : 0) + (outputs.shaped ? kMap : 0);
}

/// For so many rims per point.
double rimBytesPerPoint(const MapOutputs& outputs, double rims) {
    return outputs.walls ? rims * (kRim + (outputs.solid ? kRimOfSolid : 0)) : 0;
}

double solidBytesPerPoint(const MapOutputs& outputs) {
    return outputs.walls ? kWalledSolid : kSolid;
}

/// Of maps and meshes, without rims.
double bytesPerPoint(const DecimationParameters& parameters, const MapOutputs& outputs) {
    const double scheduled = followsSchedule(parameters, outputs) ? regionBytesPerPoint(parameters) : 0;
    double whole = 0;
    double more = outputs.again ? kAgain : 0;
    if (decimatesWhole(parameters, outputs)) {
        whole = regionBytesPerPoint(parameters);
        const int merged = canMerge(parameters) ? layers(parameters.regionCells, kMostExportCells) : 0;
        more = std::max({more, merged * kLayer, kMeasured});
    }
    return mapsBytesPerPoint(parameters, outputs) + scheduled +
           std::max(whole + more, outputs.solid ? solidBytesPerPoint(outputs) : 0);
}

/// Whether the triangles are watched. A method that works on the whole map takes all at once.
bool isWatched(const DecimationParameters& parameters, const MapOutputs& outputs) {
    return outputs.watched && decimates(parameters) && !row(parameters.method).wholeMap;
}

} // namespace

double certainBytesPerPoint(const DecimationParameters& parameters, MapOutputs outputs) {
    if (!isWatched(parameters, outputs))
        return bytesPerPoint(parameters, outputs);
    const double maps = mapsBytesPerPoint(parameters, outputs);
    const double regions = followsSchedule(parameters, outputs) ? emptyRegionBytesPerPoint(parameters) : 0;
    if (outputs.whole)
        outputs.solid = false; // of the triangles that are watched
    outputs.schedule = outputs.whole = outputs.shown = outputs.shaped = false;
    return maps + regions + bytesPerPoint(parameters, outputs);
}

double heldBytesPerPoint(const DecimationParameters& parameters, const MapOutputs& outputs) {
    const bool whole = decimatesWhole(parameters, outputs) && !outputs.solid; // a solid reuses its triangles
    return mapsBytesPerPoint(parameters, outputs) +
           (followsSchedule(parameters, outputs) ? regionBytesPerPoint(parameters) : 0) +
           (whole ? regionBytesPerPoint(parameters) : 0);
}

double meshBytesPerPoint(const DecimationParameters& parameters, const MapOutputs& outputs) {
    return bytesPerPoint(parameters, outputs) + rimBytesPerPoint(outputs, kMostRims);
}

double scheduledBytes(const Grid& grid, const DecimationParameters& parameters, const MapOutputs& outputs,
                      std::size_t faces) {
    return zmapBytes(grid) + pointsOf(grid) * certainBytesPerPoint(parameters, outputs) +
           static_cast<double>(faces) * row(parameters.method).bytesPerPoint / kFacesPerPoint;
}

double mapBytes(const Grid& grid, const DecimationParameters& parameters, const MapOutputs& outputs) {
    return zmapBytes(grid) + pointsOf(grid) * meshBytesPerPoint(parameters, outputs);
}

double surfaceBytes(const Grid& grid, std::size_t faces, std::size_t rims, const MapOutputs& outputs) {
    constexpr double kMarks = 0.25; // per point: of LatticeNumbers, and whether it is at a hole
    constexpr double kBlock = 272;  // of LatticeNumbers, for 64 points, if one of them is a vertex
    const double points = pointsOf(grid);
    const double vertices = static_cast<double>(faces) / kFacesPerPoint;
    const double numbers = kMarks * points + kBlock * std::min(points / 64, vertices);
    if (!outputs.solid)
        return static_cast<double>(faces) * kMeasured / kFacesPerPoint;
    return static_cast<double>(faces) * solidBytesPerPoint(outputs) / kFacesPerPoint + numbers +
           (outputs.walls ? static_cast<double>(rims) * kRimOfSolid : 0);
}

double expectedMapBytes(const Grid& grid, const DecimationParameters& parameters, const MapOutputs& outputs) {
    double machined = 0;
    if (isWatched(parameters, outputs))
        machined = (followsSchedule(parameters, outputs) ? kMachined : 0) + (outputs.whole ? kMachined : 0);
    return zmapBytes(grid) + pointsOf(grid) * (certainBytesPerPoint(parameters, outputs) + machined +
                                               rimBytesPerPoint(outputs, kMachinedRims));
}

Result<void> checkMapMemory(const StockBox& stock, const Grid& grid, const DecimationParameters& parameters,
                            const MapOutputs& outputs, double limitBytes) {
    const double points = pointsOf(grid);
    const double most = row(parameters.method).mostPoints;
    if ((followsSchedule(parameters, outputs) || decimatesWhole(parameters, outputs)) && points > most)
        return failure(decimation_finding::kMethodMapTooLarge,
                       {kMethodChoices[static_cast<std::size_t>(parameters.method)].key,
                        fmt::format("{:.0f}", most), fmt::format("{:.0f}", points)});
    DecimationParameters coarser = parameters; // of coarser grids, for which defaultRegion() is smaller
    coarser.regionCells = std::min(parameters.regionCells, row(parameters.method).defaultRegion);
    const double anySurface =
        std::max(meshBytesPerPoint(parameters, outputs), meshBytesPerPoint(coarser, outputs));
    return checkMemory(stock, grid, limitBytes, certainBytesPerPoint(parameters, outputs), anySurface);
}

double bytesAtRest(const DecimationParameters& parameters, const Grid& grid, std::size_t faces) {
    constexpr double kWorkers = 32e6;
    constexpr double kFace = 12.5;
    // Within the allowance everywhere instead of at the points: on steep walls, up to this many times as many
    // faces were seen.
    constexpr double kMoreFaces = 1.4;
    const double regions = pointsOf(grid) / (parameters.regionCells * parameters.regionCells);
    const int meshes = 1 + layers(parameters.regionCells, RefinedSurface::kMostCells);
    return kWorkers + 3 * kRegion * regions + static_cast<double>(faces) * kMoreFaces * kFace * meshes;
}

} // namespace proveout
