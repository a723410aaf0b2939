// SPDX-License-Identifier: GPL-3.0-or-later
// The grid over a stock and the memory it needs; both are computed in double before anything is allocated.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/base/memory.h"
#include "core/zmap/zmap.h"
#include "core/zmap/zmap_findings.h"

namespace proveout {

namespace {

/// The heights of a map are counted by 32-bit indices where meshes are made of them.
constexpr double kMostPoints = std::numeric_limits<std::int32_t>::max();
/// Larger sizes are mistakes of units or typing, and would use up the digits of a double.
constexpr double kLargestStock = 1e7;
/// The largest ratio of length to width or of width to length: on a narrower stock even cells as large as its
/// short side are more points than a map of a usual stock has.
constexpr double kLargestRatio = 1e5;
/// The largest coordinate of the corner of a stock, in either direction; the same limit as in a job file.
constexpr double kFarthestCorner = 1e7;
/// Neighbouring points of a grid are at least this many steps of a double apart.
constexpr double kLeastSteps = 16;
/// A tile with its reference count and its place in the array.
constexpr double kTileBytes = sizeof(Tile) + 64;

double pointsAlong(double length, double spacing) {
    return std::round(length / spacing) + 1;
}

double bytesOf(double nx, double ny, double bytesPerPoint = 0) {
    return std::ceil(nx / Tile::kSize) * std::ceil(ny / Tile::kSize) * kTileBytes + nx * ny * bytesPerPoint;
}

/// The finest spacing, to three digits and rounded upwards, whose map has no more points and bytes than
/// given.
double finestWithin(const StockBox& stock, double mostPoints, double mostBytes, double bytesPerPoint = 0) {
    const auto fits = [&](double spacing) {
        const double nx = pointsAlong(stock.width, spacing);
        const double ny = pointsAlong(stock.depth, spacing);
        return nx * ny <= mostPoints && bytesOf(nx, ny, bytesPerPoint) <= mostBytes;
    };
    double fine = 1e-12;
    double coarse = std::max(stock.width, stock.depth);
    for (int step = 0; step < 100; ++step) {
        const double middle = std::sqrt(fine * coarse);
        (fits(middle) ? coarse : fine) = middle;
    }
    const double digit = std::pow(10.0, std::floor(std::log10(coarse)) - 2);
    return std::ceil(coarse / digit) * digit;
}

bool reasonable(double length) {
    return std::isfinite(length) && length > 0 && length <= kLargestStock;
}

Argument pointsOf(double nx, double ny) {
    // Whole numbers as long as they are readable.
    constexpr double kReadable = 1e9;
    return std::max(nx, ny) < kReadable ? figures("{:.0f} × {:.0f}", nx, ny)
                                        : figures("{:.3g} × {:.3g}", nx, ny);
}

Argument sizeOf(const StockBox& stock) {
    return figures("{:g}x{:g}x{:g}", stock.width, stock.depth, stock.height);
}

/// The largest coordinate of the grid in plan; at least 1 mm, so that the spacing is not lost in values
/// computed from it either.
double farthestPoint(const StockBox& stock) {
    return std::max({1.0, std::abs(stock.corner.x), std::abs(stock.corner.y),
                     std::abs(stock.corner.x + stock.width), std::abs(stock.corner.y + stock.depth)});
}

double stepOfDouble(double value) {
    return std::nextafter(value, std::numeric_limits<double>::infinity()) - value;
}

} // namespace

Result<void> checkSpacing(double spacing) {
    if (!std::isfinite(spacing) || spacing <= 0)
        return failure(zmap_finding::kGridSpacingBad, {figures("{:g}", spacing)});
    return {};
}

Result<Grid> makeGrid(const StockBox& stock, double spacing) {
    if (!reasonable(stock.width) || !reasonable(stock.depth) || !reasonable(stock.height))
        return failure(zmap_finding::kStockSizeBad, {sizeOf(stock), figures("{:g}", kLargestStock)});
    if (std::max(stock.width, stock.depth) > kLargestRatio * std::min(stock.width, stock.depth))
        return failure(zmap_finding::kStockSizeNarrow, {sizeOf(stock), fmt::format("{:.0f}", kLargestRatio)});
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(stock.corner[axis]) <= kFarthestCorner))
            return failure(zmap_finding::kStockOriginBad,
                           {figures("{:g}", kFarthestCorner), figures("{:g}", kFarthestCorner)});
    }
    if (auto fine = checkSpacing(spacing); !fine)
        return tl::unexpected(std::move(fine.error()));
    const double nx = pointsAlong(stock.width, spacing);
    const double ny = pointsAlong(stock.depth, spacing);
    if (nx < 2 || ny < 2)
        return failure(zmap_finding::kGridTooCoarse, {figures("{:g}", spacing), sizeOf(stock),
                                                      figures("{:g}", std::min(stock.width, stock.depth))});
    if (nx * ny > kMostPoints)
        return failure(
            zmap_finding::kGridTooFine,
            {figures("{:g}", spacing), pointsOf(nx, ny), sizeOf(stock),
             figures("{}", readableBytes(bytesOf(nx, ny))),
             figures("{:g}", finestWithin(stock, kMostPoints, std::numeric_limits<double>::infinity()))});
    const double farthest = farthestPoint(stock);
    if (spacing < kLeastSteps * stepOfDouble(farthest))
        return failure(zmap_finding::kGridLostInRounding,
                       {figures("{:g}", spacing), figures("{:g}", farthest)});
    Grid grid;
    grid.nx = static_cast<int>(nx);
    grid.ny = static_cast<int>(ny);
    grid.hx = stock.width / (grid.nx - 1);
    grid.hy = stock.depth / (grid.ny - 1);
    grid.x0 = stock.corner.x;
    grid.y0 = stock.corner.y;
    return grid;
}

double gridPoints(const StockBox& stock, double spacing) {
    const Result<Grid> grid = makeGrid(stock, spacing);
    return grid ? static_cast<double>(grid->nx) * grid->ny : 0;
}

double zmapBytes(const Grid& grid) {
    return bytesOf(grid.nx, grid.ny);
}

std::optional<double> finestSpacing(const StockBox& stock, double mostBytes, double bytesPerPoint) {
    if (bytesOf(2, 2, bytesPerPoint) > mostBytes) // not even one tile fits
        return std::nullopt;
    return finestWithin(stock, kMostPoints, mostBytes, bytesPerPoint);
}

Result<void> checkMemory(const StockBox& stock, const Grid& grid, double availableBytes, double bytesPerPoint,
                         double coarserBytesPerPoint) {
    const double needed = bytesOf(grid.nx, grid.ny, bytesPerPoint);
    if (needed <= availableBytes)
        return {};
    const auto would = finestSpacing(stock, availableBytes, std::max(bytesPerPoint, coarserBytesPerPoint));
    if (!would)
        return failure(zmap_finding::kMemoryTooSmall,
                       {figures("{}", readableBytes(needed)), figures("{}", readableBytes(availableBytes))});
    return failure(zmap_finding::kGridNeedsTooMuchMemory,
                   {figures("{}", grid.nx), figures("{}", grid.ny), figures("{}", readableBytes(needed)),
                    figures("{}", readableBytes(availableBytes)), figures("{:g}", *would)});
}

} // namespace proveout
