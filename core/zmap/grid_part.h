// SPDX-License-Identifier: GPL-3.0-or-later
// A rectangular part of the points of a grid that as a whole may be far too fine for the memory.
#pragma once

#include <memory>

#include "core/base/index_rect.h"
#include "core/zmap/stock_shape.h"

namespace proveout {

/// A rectangle in plan, program coordinates, mm.
struct PlanBox {
    Vec2 lo{0};
    Vec2 hi{0};

    friend bool operator==(const PlanBox&, const PlanBox&) = default;
};

/// A rectangular part of the points of a larger grid. Their coordinates are computed as in that grid, to the
/// last bit, and so is everything derived from them. Value type.
struct GridPart {
    Vec2 origin{0};    ///< of the whole grid: its point (0, 0)
    double hx = 1;     ///< mm
    double hy = 1;     ///< mm
    double firstI = 0; ///< where in the whole grid the part begins: whole numbers
    double firstJ = 0;
    int nx = 2; ///< points of the part along x
    int ny = 2;

    GridPart() = default;
    /// The whole grid.
    explicit GridPart(const Grid& grid)
        : origin(grid.x0, grid.y0), hx(grid.hx), hy(grid.hy), nx(grid.nx), ny(grid.ny) {}

    [[nodiscard]] double x(int i) const { return origin.x + hx * (firstI + i); }
    [[nodiscard]] double y(int j) const { return origin.y + hy * (firstJ + j); }
    /// The part as a grid of its own.
    [[nodiscard]] Grid grid() const { return {nx, ny, hx, hy, x(0), y(0)}; }
    /// The box of stock over the part.
    [[nodiscard]] StockBox stock(const StockBox& whole) const {
        return {{x(0), y(0), whole.corner.z}, hx * (nx - 1), hy * (ny - 1), whole.height};
    }
    /// The same points, extended on all sides so that they make whole tiles of the whole grid.
    [[nodiscard]] GridPart inWholeTiles() const;
};

/// The points, within a box in plan, of the grid that the stock would have at that spacing (makeGrid()); the
/// sides of the box are moved to the nearest points, at least one cell apart. Errors: those of makeGrid(),
/// except that the number of points is that of the part; a box that has no area or is not within the stock.
[[nodiscard]] Result<GridPart> makeGridPart(const StockBox& stock, double spacing, const PlanBox& box);

/// A body that can make the map of a part.
class PartedStock {
public:
    PartedStock() = default;
    PartedStock(const PartedStock&) = delete;
    PartedStock& operator=(const PartedStock&) = delete;
    virtual ~PartedStock() = default;

    /// StockBody::uncut() for some of the points; the map has the stock of the part.
    [[nodiscard]] virtual ZMap uncutPart(const StockBox& stock, const GridPart& part) const = 0;
    /// The rims of that map, as StockBody::rims().
    [[nodiscard]] virtual RimMap rimsOfPart(const StockBox& /*stock*/, const GridPart& /*part*/) const {
        return {};
    }
};

/// uncutStock() for some of the points, to the last bit; the map has the box and the grid of the part.
/// Allocates the memory.
[[nodiscard]] ZMap uncutPart(const StockBox& stock, const StockShape& shape, const GridPart& part);

/// topOf() for places over the part.
[[nodiscard]] std::unique_ptr<StockTop> topOfPart(const StockBox& stock, const StockShape& shape,
                                                  const GridPart& part);

} // namespace proveout
