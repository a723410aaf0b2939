// SPDX-License-Identifier: GPL-3.0-or-later
// A rectangle of the points of a grid, which as a whole may be far too fine to be held.
#pragma once

#include "core/base/index_rect.h"
#include "core/zmap/stock_shape.h"

namespace proveout {

/// A rectangle in plan, program coordinates, mm.
struct PlanBox {
    Vec2 lo{0};
    Vec2 hi{0};

    friend bool operator==(const PlanBox&, const PlanBox&) = default;
};

/// Points of a larger grid. Their coordinates are computed as there, to the last bit, and so is all that
/// follows from them. Value type.
struct GridPart {
    Vec2 origin{0};    ///< of the whole grid: its point (0, 0)
    double hx = 1;     ///< mm
    double hy = 1;     ///< mm
    double firstI = 0; ///< where in the whole grid the part begins: whole numbers
    double firstJ = 0;
    int nx = 2; ///< points of the part along x
    int ny = 2;

    GridPart() = default;
    /// All of it.
    explicit GridPart(const Grid& grid)
        : origin(grid.x0, grid.y0), hx(grid.hx), hy(grid.hy), nx(grid.nx), ny(grid.ny) {}

    [[nodiscard]] double x(int i) const { return origin.x + hx * (firstI + i); }
    [[nodiscard]] double y(int j) const { return origin.y + hy * (firstJ + j); }
    /// As if there were nothing beside it.
    [[nodiscard]] Grid grid() const { return {nx, ny, hx, hy, x(0), y(0)}; }
    /// The box of stock over it.
    [[nodiscard]] StockBox stock(const StockBox& whole) const {
        return {{x(0), y(0), whole.corner.z}, hx * (nx - 1), hy * (ny - 1), whole.height};
    }
    /// The same points and those before and behind them that make whole tiles of the whole grid.
    [[nodiscard]] GridPart inWholeTiles() const;
};

/// The points of the grid that the stock would have at that spacing (makeGrid()) within a box in plan, whose
/// sides go to the nearest of them; at least one cell. Errors: those of makeGrid(), but for the number of
/// points, which is that of the part; a box that has no area, or is not within the stock.
[[nodiscard]] Result<GridPart> makeGridPart(const StockBox& stock, double spacing, const PlanBox& box);

/// A body of which a part can be asked for.
class PartedStock {
public:
    PartedStock() = default;
    PartedStock(const PartedStock&) = delete;
    PartedStock& operator=(const PartedStock&) = delete;
    virtual ~PartedStock() = default;

    /// StockBody::uncut() of some of the points; the map has the stock of the part.
    [[nodiscard]] virtual ZMap uncutPart(const StockBox& stock, const GridPart& part) const = 0;
};

/// uncutStock() of some of the points, to the last bit; the map has the box and the grid of the part. Memory
/// is taken here.
[[nodiscard]] ZMap uncutPart(const StockBox& stock, const StockShape& shape, const GridPart& part);

} // namespace proveout
