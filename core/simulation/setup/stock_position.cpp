// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/stock_position.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string>

#include "core/base/figures_argument.h"
#include "core/simulation/setup/setup_findings.h"

namespace proveout {

namespace {

Box3 boxOf(const StockBox& stock) {
    Box3 box;
    box.add(Vec3(stock.corner.x, stock.corner.y, stock.floorZ()));
    box.add(Vec3(stock.corner.x + stock.width, stock.corner.y + stock.depth, stock.topZ()));
    return box;
}

/// Of the cutters that the program uses; 0 if it has none.
double largestRadius(const Program& program, const Setup& setup, const ToolChoice& tools) {
    double radius = 0;
    for (const Program::ToolRun& run : program.toolRuns()) {
        if (const Cutter* cutter = setup.tools.find(tools.tool(run.tool)))
            radius = std::max(radius, cutter->radius());
    }
    return radius;
}

/// "X0 to 40, Y0 to 30, Z-2 to 5"
Argument rangesOf(const Box3& box) {
    return figures("X{:.6g}…{:.6g} Y{:.6g}…{:.6g} Z{:.6g}…{:.6g}", box.lo.x, box.hi.x, box.lo.y, box.hi.y,
                   box.lo.z, box.hi.z);
}

Diagnostic neverCuts(const Program& program, const StockBox& stock) {
    return diagnosticOf(setup_finding::kNeverCuts,
                        {rangesOf(program.cuttingBounds()), rangesOf(boxOf(stock))});
}

bool reaches(const Box3& path, const Box3& stock, double radius) {
    return path.lo.z < stock.hi.z && path.lo.x - radius < stock.hi.x && path.hi.x + radius > stock.lo.x &&
           path.lo.y - radius < stock.hi.y && path.hi.y + radius > stock.lo.y;
}

struct Overshoot {
    const char* side;
    double beyond; ///< mm
    double size;   ///< of the stock in that direction, mm
};

/// A path that ends above the stock is normal, so its upper side does not count.
std::array<Overshoot, 5> overshoots(const Box3& path, const Box3& stock) {
    const Vec3 size = stock.hi - stock.lo;
    return {{{"X-", stock.lo.x - path.lo.x, size.x},
             {"X+", path.hi.x - stock.hi.x, size.x},
             {"Y-", stock.lo.y - path.lo.y, size.y},
             {"Y+", path.hi.y - stock.hi.y, size.y},
             {"Z-", stock.lo.z - path.lo.z, size.z}}};
}

} // namespace

Diagnostics misplacedStock(const Program& program, const Setup& setup, const ToolChoice& tools) {
    constexpr double kSlack = 1e-6;
    const double radius = largestRadius(program, setup, tools);
    const Box3& path = program.cuttingBounds();
    if (!tools.missing().empty() || path.empty() || radius <= 0)
        return {};
    const Box3 stock = boxOf(setup.stock);
    if (!reaches(path, stock, radius))
        return {neverCuts(program, setup.stock)};
    Diagnostics warnings;
    for (const Overshoot& side : overshoots(path, stock)) {
        if (side.beyond < std::max(side.size, 2 * radius) - kSlack)
            continue;
        warnings.push_back(
            diagnosticOf(setup_finding::kStockMissed,
                         {figures("{:.6g}", side.beyond), side.side, figures("{:.6g}", side.size)}));
    }
    return warnings;
}

Diagnostics untouchedStock(const Program& program, const Setup& setup, const ToolChoice& tools) {
    const Box3& path = program.cuttingBounds();
    const double radius = largestRadius(program, setup, tools);
    if (!tools.missing().empty() || path.empty() || radius <= 0 || !reaches(path, boxOf(setup.stock), radius))
        return {}; // another message reports this
    return {neverCuts(program, setup.stock)};
}

} // namespace proveout
