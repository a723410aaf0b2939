// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"

namespace proveout {

/// A box of stock. `corner` is its lower-left-top corner in program coordinates: least x, least y, top z; mm.
struct StockBox {
    Vec3 corner{0};
    double width = 100; ///< x
    double depth = 100; ///< y
    double height = 30; ///< z, downwards from the corner

    [[nodiscard]] double topZ() const { return corner.z; }
    [[nodiscard]] double floorZ() const { return corner.z - height; }
    friend bool operator==(const StockBox&, const StockBox&) = default;
};

/// The grid over a stock: spacing adjusted per axis so that it divides the stock exactly. nx = round(width /
/// h) + 1, hx = width / (nx - 1), and the same for y.
struct Grid {
    int nx = 2; ///< points along x
    int ny = 2;
    double hx = 1; ///< mm
    double hy = 1;
    double x0 = 0; ///< program coordinates of point (0, 0)
    double y0 = 0;

    [[nodiscard]] double x(int i) const { return x0 + hx * i; }
    [[nodiscard]] double y(int j) const { return y0 + hy * j; }
    friend bool operator==(const Grid&, const Grid&) = default;
};

/// Refuses a spacing that is not positive and finite.
[[nodiscard]] Result<void> checkSpacing(double spacing);

/// Errors: sizes or spacing that are not positive and finite, sides in plan of more than 1 : 100 000, a
/// corner beyond 10 km, a spacing lost in the precision of its coordinates, less than one cell, too many
/// points to index.
[[nodiscard]] Result<Grid> makeGrid(const StockBox& stock, double spacing);

/// The number of points of that grid; 0 where it cannot be made.
[[nodiscard]] double gridPoints(const StockBox& stock, double spacing);

/// Bytes of a z-map over the grid in which every tile has been cut. (Uncut tiles of a box are one tile.)
[[nodiscard]] double zmapBytes(const Grid& grid);

/// The finest spacing, to three digits, whose map, with `bytesPerPoint` more for each point, needs no more
/// than `mostBytes`; nothing if there is none.
[[nodiscard]] std::optional<double> finestSpacing(const StockBox& stock, double mostBytes,
                                                  double bytesPerPoint);

/// Refuses a grid that needs more memory than is allowed (memoryLimitBytes()); the message names the figure
/// and the finest spacing that would fit. `bytesPerPoint`: what else will be made of each point, above all
/// meshes; `coarserBytesPerPoint`: the same on coarser grids, where that is more.
[[nodiscard]] Result<void> checkMemory(const StockBox& stock, const Grid& grid, double availableBytes,
                                       double bytesPerPoint = 0, double coarserBytesPerPoint = 0);

/// "WxDxH" and "X,Y,Z" of the command line.
[[nodiscard]] Result<Vec3> parseStockSize(std::string_view text);
[[nodiscard]] Result<Vec3> parsePoint(std::string_view text);

} // namespace proveout
