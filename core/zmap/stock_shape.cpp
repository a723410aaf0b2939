// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/stock_shape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/zmap/zmap_findings.h"

namespace proveout {

namespace {

/// The surface between the points of a z-map: within each cell, the mean of its corners weighted by nearness.
class MapTop final : public StockTop {
public:
    explicit MapTop(ZMapSnapshot map) : m_map(std::move(map)) {}

    [[nodiscard]] double height(const Vec2& place) const override {
        const Grid& grid = m_map.grid();
        const double u = (place.x - grid.x0) / grid.hx;
        const double v = (place.y - grid.y0) / grid.hy;
        if (!(u >= 0 && v >= 0 && u <= grid.nx - 1 && v <= grid.ny - 1))
            return kAbsent;
        const int i = std::min(static_cast<int>(u), grid.nx - 2);
        const int j = std::min(static_cast<int>(v), grid.ny - 2);
        const auto at = [&](int di, int dj) { return double{m_map.height(i + di, j + dj)}; };
        return std::lerp(std::lerp(at(0, 0), at(1, 0), u - i), std::lerp(at(0, 1), at(1, 1), u - i), v - j);
    }
    [[nodiscard]] double highest(const Vec2& lo, const Vec2& hi) const override {
        const Grid& grid = m_map.grid();
        const auto first = [](double at, double from, double step, int count) {
            return static_cast<int>(std::clamp(std::floor((at - from) / step), 0.0, count - 1.0));
        };
        const auto last = [](double at, double from, double step, int count) {
            return static_cast<int>(std::clamp(std::ceil((at - from) / step), 0.0, count - 1.0));
        };
        double highest = kAbsent;
        for (int j = first(lo.y, grid.y0, grid.hy, grid.ny); j <= last(hi.y, grid.y0, grid.hy, grid.ny); ++j)
            for (int i = first(lo.x, grid.x0, grid.hx, grid.nx); i <= last(hi.x, grid.x0, grid.hx, grid.nx);
                 ++i)
                highest = std::max(highest, double{m_map.height(i, j)});
        return highest;
    }
    [[nodiscard]] bool knowsWalls() const override { return false; }

private:
    ZMapSnapshot m_map;
};

} // namespace

Result<void> checkShape(const StockShape& shape) {
    if (shape.kind == StockKind::box || shape.body != nullptr)
        return {};
    return failure(shape.file.empty() ? zmap_finding::kStockIncompleteNoFile : zmap_finding::kStockIncomplete,
                   {shape.file.filename().string()});
}

UncutStock uncutStock(const StockBox& stock, const StockShape& shape, const Grid& grid) {
    if (shape.body == nullptr)
        return {ZMap(stock, grid), {}};
    return shape.body->uncut(stock, grid);
}

std::unique_ptr<StockTop> topOf(const StockBox& stock, const StockShape& shape, const Grid& grid) {
    if (auto top = shape.body->top(stock))
        return top;
    return mapTopOf(stock, shape, grid);
}

std::unique_ptr<StockTop> mapTopOf(const StockBox& stock, const StockShape& shape, const Grid& grid) {
    return std::make_unique<MapTop>(shape.body->uncut(stock, grid).zmap.snapshot());
}

} // namespace proveout
