// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/grid_part.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/zmap/map_top.h"
#include "core/zmap/zmap_findings.h"

namespace proveout {

namespace {

/// Positions are typed or computed, and so are rounded.
constexpr double kBesides = 1e-6; // mm

struct Points {
    double first;
    double last;
};

/// The points nearest to `lo` and `hi` along one side of the stock.
Points pointsFrom(double lo, double hi, double spacing, double count) {
    const double first = std::clamp(std::round(lo / spacing), 0.0, count - 2);
    return {first, std::clamp(std::round(hi / spacing), first + 1, count - 1)};
}

Argument textOf(const PlanBox& box) {
    return figures("X{:g}…{:g} Y{:g}…{:g}", box.lo.x, box.hi.x, box.lo.y, box.hi.y);
}

Result<void> checkBox(const StockBox& stock, const PlanBox& box) {
    if (!(box.lo.x < box.hi.x && box.lo.y < box.hi.y))
        return failure(zmap_finding::kBoxWithoutArea, {textOf(box)});
    const PlanBox whole{Vec2(stock.corner), Vec2(stock.corner) + Vec2(stock.width, stock.depth)};
    if (!(glm::all(glm::greaterThanEqual(box.lo, whole.lo - kBesides)) &&
          glm::all(glm::lessThanEqual(box.hi, whole.hi + kBesides))))
        return failure(zmap_finding::kBoxOutsideStock, {textOf(box), textOf(whole)});
    return {};
}

} // namespace

GridPart GridPart::inWholeTiles() const {
    const auto before = [](double first) { return static_cast<int>(std::fmod(first, Tile::kSize)); };
    const auto wholeTiles = [](int points) { return (points + Tile::kSize - 1) / Tile::kSize * Tile::kSize; };
    GridPart larger = *this;
    larger.firstI -= before(firstI);
    larger.firstJ -= before(firstJ);
    larger.nx = wholeTiles(nx + before(firstI));
    larger.ny = wholeTiles(ny + before(firstJ));
    return larger;
}

Result<GridPart> makeGridPart(const StockBox& stock, double spacing, const PlanBox& box) {
    if (auto fine = checkSpacing(spacing); !fine)
        return tl::unexpected(std::move(fine.error()));
    // Checks the stock itself, at a spacing that it can have.
    if (auto whole = makeGrid(stock, std::min(stock.width, stock.depth)); !whole)
        return tl::unexpected(std::move(whole.error()));
    if (auto fine = checkBox(stock, box); !fine)
        return tl::unexpected(std::move(fine.error()));
    // The same checks for the part: too coarse, too fine, lost in rounding.
    const StockBox around{{box.lo, stock.corner.z}, box.hi.x - box.lo.x, box.hi.y - box.lo.y, stock.height};
    if (auto grid = makeGrid(around, spacing); !grid)
        return tl::unexpected(std::move(grid.error()));
    const double columns = std::round(stock.width / spacing) + 1;
    const double rows = std::round(stock.depth / spacing) + 1;
    GridPart part;
    part.origin = Vec2(stock.corner);
    part.hx = stock.width / (columns - 1);
    part.hy = stock.depth / (rows - 1);
    const Points x = pointsFrom(box.lo.x - stock.corner.x, box.hi.x - stock.corner.x, part.hx, columns);
    const Points y = pointsFrom(box.lo.y - stock.corner.y, box.hi.y - stock.corner.y, part.hy, rows);
    part.firstI = x.first;
    part.firstJ = y.first;
    part.nx = static_cast<int>(x.last - x.first) + 1;
    part.ny = static_cast<int>(y.last - y.first) + 1;
    return part;
}

ZMap uncutPart(const StockBox& stock, const StockShape& shape, const GridPart& part) {
    const auto* parted = dynamic_cast<const PartedStock*>(shape.body.get());
    return parted == nullptr ? ZMap(part.stock(stock), part.grid()) : parted->uncutPart(stock, part);
}

std::unique_ptr<StockTop> topOfPart(const StockBox& stock, const StockShape& shape, const GridPart& part) {
    if (auto top = shape.body->top(stock))
        return top;
    ZMapSnapshot map = uncutPart(stock, shape, part).snapshot();
    if (const auto* parted = dynamic_cast<const PartedStock*>(shape.body.get()))
        map.setRims(parted->rimsOfPart(stock, part));
    return std::make_unique<MapTop>(std::move(map));
}

} // namespace proveout
