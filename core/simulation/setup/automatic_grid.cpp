// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/automatic_grid.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <thread>

#include "core/base/figures_argument.h"
#include "core/base/memory.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/simulation/setup/setup_findings.h"

namespace proveout {

namespace {

constexpr double kPointsAcross = 10;       ///< across the smallest cutter
constexpr double kFewPointsAcross = 5;     ///< with fewer points than this its cuts lose their shape
constexpr double kFinestForPicture = 0.01; ///< mm
constexpr double kFinest = 0.001;          ///< mm; the accuracy of cuts
constexpr double kPointsOfCore = 1e6;
constexpr double kLeastPoints = 1e4;
constexpr double kNextStep = 1.001; ///< the step to the next value of two digits, which is rounded up

/// Rounded to two digits, so that the number is easy to read and to enter again. `slack` keeps 0.6 from
/// becoming 0.59.
double twoDigits(double spacing, bool up) {
    constexpr double kSlack = 1e-9;
    const double scale = std::pow(10.0, 1 - std::floor(std::log10(spacing)));
    const double steps = spacing * scale;
    return (up ? std::ceil(steps - kSlack) : std::floor(steps + kSlack)) / scale;
}

/// The spacing of a grid with this many points: (width / h + 1) (depth / h + 1) = points.
double spacingOf(const StockBox& stock, double points) {
    const double sides = stock.width + stock.depth;
    return (sides + std::sqrt(sides * sides + 4 * (points - 1) * stock.width * stock.depth)) /
           (2 * (points - 1));
}

/// Whether a run of motions moves at feed.
bool cuts(const Program& program, const Program::ToolRun& run) {
    for (std::size_t index = run.first; index < run.last; ++index) {
        if (program.motion(index).kind != MotionKind::rapid)
            return true;
    }
    return false;
}

double bytesOfPoint(const DecimationParameters& parameters, const MapOutputs& outputs) {
    constexpr int kSide = 1001;
    Grid grid;
    grid.nx = grid.ny = kSide;
    return zmapBytes(grid) / (double{kSide} * kSide) + meshBytesPerPoint(parameters, outputs);
}

} // namespace

GridLimits gridLimits(const DecimationParameters& parameters, const MapOutputs& outputs) {
    GridLimits limits;
    const double cores = std::max(1U, std::thread::hardware_concurrency());
    limits.most = std::clamp(cores * kPointsOfCore, kPointsOfCore, limits.most);
    limits.most = std::min(limits.most, row(parameters.method).mostPoints);
    const double bytes = bytesOfPoint(parameters, outputs);
    const double half = static_cast<double>(memoryLimitBytes()) / 2;
    while (limits.most > kLeastPoints && limits.most * bytes > half)
        limits.most /= 2;
    limits.fewest = std::min(limits.fewest, limits.most);
    return limits;
}

std::optional<CutterInUse> smallestCutter(const Program& program, const Setup& setup,
                                          const ToolChoice& tools) {
    std::optional<CutterInUse> smallest;
    for (const Program::ToolRun& run : program.toolRuns()) {
        const int number = tools.tool(run.tool);
        const Cutter* cutter = setup.tools.find(number);
        if (cutter != nullptr && (!smallest || 2 * cutter->radius() < smallest->diameter) &&
            cuts(program, run))
            smallest = {number, 2 * cutter->radius()};
    }
    return smallest;
}

double automaticSpacing(const StockBox& stock, const std::optional<CutterInUse>& smallest,
                        const GridLimits& limits) {
    const double shorter = std::min(stock.width, stock.depth);
    if (!(shorter > 0) || !std::isfinite(stock.width + stock.depth))
        return Setup().spacing; // makeGrid() reports the error
    double spacing = std::max(spacingOf(stock, limits.fewest), kFinestForPicture);
    if (smallest)
        spacing = std::min(spacing, smallest->diameter / kPointsAcross);
    spacing = twoDigits(std::max(spacing, kFinest), false);
    if (const double least = spacingOf(stock, limits.most); spacing < least)
        spacing = twoDigits(least, true);
    while (gridPoints(stock, spacing) > limits.most) // makeGrid() rounds, which matters on a narrow stock
        spacing = twoDigits(spacing * kNextStep, true);
    return std::min(spacing, shorter);
}

double gridSpacing(const Setup& setup, const Program& program, const GridLimits& limits) {
    if (!setup.automaticGrid)
        return setup.spacing;
    if (setup.shape.body)
        if (const auto spacing = setup.shape.body->spacing())
            return *spacing;
    return automaticSpacing(setup.stock, smallestCutter(program, setup, ToolChoice(program, setup)), limits);
}

Diagnostics coarseGrid(const Grid& grid, const std::optional<CutterInUse>& smallest, bool automatic) {
    constexpr double kSlack = 1 + 1e-9;
    const double spacing = std::max(grid.hx, grid.hy);
    if (!smallest || spacing * kFewPointsAcross <= smallest->diameter * kSlack)
        return {};
    const FindingRow& row = automatic ? setup_finding::kGridCoarseAutomatic : setup_finding::kGridCoarse;
    return {diagnosticOf(row, {figures("{:.4g}", spacing), std::to_string(smallest->tool),
                               figures("{:.4g}", smallest->diameter),
                               figures("{:.1f}", smallest->diameter / spacing)})};
}

} // namespace proveout
