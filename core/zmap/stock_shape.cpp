// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/stock_shape.h"

#include <utility>

#include "core/zmap/map_top.h"
#include "core/zmap/zmap_findings.h"

namespace proveout {

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
    ZMapSnapshot map = shape.body->uncut(stock, grid).zmap.snapshot();
    map.setRims(shape.body->rims(stock, grid));
    return std::make_unique<MapTop>(std::move(map));
}

std::unique_ptr<StockTop> mapTopOf(const StockBox& stock, const StockShape& shape, const Grid& grid) {
    return std::make_unique<MapTop>(shape.body->uncut(stock, grid).zmap.snapshot());
}

} // namespace proveout
