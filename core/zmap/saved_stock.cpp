// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/saved_stock.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/zmap/grid_part.h"
#include "core/zmap/stock_body_findings.h"
#include "core/zmap/stock_findings.h"
#include "core/zmap/turned_rims.h"
#include "core/zmap/zmap_findings.h"

namespace proveout {

namespace {

struct Index {
    int i, j;
};

/// A new map with the height `heightAt(i, j)` at each point.
template<class HeightAt>
ZMap mapOf(const StockBox& stock, const Grid& grid, HeightAt&& heightAt) {
    ZMap zmap(stock, grid);
    for (std::size_t index = 0; index < zmap.tileCount(); ++index) {
        const IndexRect rect = zmap.tileRect(index);
        Tile& tile = zmap.tileForWriting(index);
        for (int j = rect.j0; j < rect.j1; ++j)
            for (int i = rect.i0; i < rect.i1; ++i)
                tile.at(i - rect.i0, j - rect.j0) = heightAt(i, j);
        tile.refreshMaximum();
    }
    return zmap;
}

/// Another grid over the same tiles.
ZMap sameTiles(const ZMapSnapshot& map, const StockBox& stock, const Grid& grid) {
    PersistentArray<std::shared_ptr<const Tile>> tiles;
    for (std::size_t index = 0; index < map.tileCount(); ++index)
        tiles.push_back(map.tile(index));
    return ZMap(ZMapSnapshot(stock, grid, std::move(tiles)));
}

ZMapSnapshot turned(const ZMapSnapshot& map, StockTurn turn) {
    if (turn == StockTurn::none)
        return map;
    StockBox stock = map.stock();
    Grid grid = map.grid();
    if (turn != StockTurn::half) {
        std::swap(stock.width, stock.depth);
        std::swap(grid.nx, grid.ny);
        std::swap(grid.hx, grid.hy);
    }
    const int lastI = grid.nx - 1;
    const int lastJ = grid.ny - 1;
    const auto before = [&](int i, int j) -> Index {
        switch (turn) {
        case StockTurn::quarter:
            return {j, lastI - i};
        case StockTurn::half:
            return {lastI - i, lastJ - j};
        default:
            return {lastJ - j, i};
        }
    };
    ZMapSnapshot result = mapOf(stock, grid, [&](int i, int j) {
                              const Index from = before(i, j);
                              return map.height(from.i, from.j);
                          }).snapshot();
    result.setRims(turnedRims(map, turn));
    return result;
}

float highestOf(const ZMapSnapshot& map) {
    float highest = map.floor();
    for (std::size_t index = 0; index < map.tileCount(); ++index) {
        const IndexRect rect = map.tileRect(index);
        for (int j = 0; j < rect.height(); ++j)
            for (int i = 0; i < rect.width(); ++i)
                highest = std::max(highest, map.tile(index)->at(i, j));
    }
    return highest;
}

/// The old floor is the new top wherever there is material on it.
ZMapSnapshot flipped(const ZMapSnapshot& map, StockFlip flip, Undercut& undercut) {
    const float highest = highestOf(map);
    StockBox stock = map.stock();
    stock.height += double{highest};
    const Grid& grid = map.grid();
    const bool aboutX = flip == StockFlip::aboutX;
    const auto newFloor = static_cast<float>(-stock.height);
    ZMapSnapshot result =
        mapOf(stock, grid, [&](int i, int j) {
            const float before = map.height(aboutX ? i : grid.nx - 1 - i, aboutX ? grid.ny - 1 - j : j);
            if (before <= map.floor())
                return newFloor;
            const double gap = double{highest} - double{before};
            const double weight =
                (i == 0 || i == grid.nx - 1 ? 0.5 : 1.0) * (j == 0 || j == grid.ny - 1 ? 0.5 : 1.0);
            if (gap > Undercut::kLeast)
                undercut.add(gap * weight * grid.hx * grid.hy, gap,
                             {grid.x(i), grid.y(j), stock.floorZ() + gap});
            return 0.0F;
        }).snapshot();
    result.setRims(flippedRims(map, flip, newFloor));
    return result;
}

/// The saved points near a point of another grid along one axis; `at` is the position of that point in saved
/// steps.
struct Neighbours {
    int below;     ///< the saved point at or before it
    double beyond; ///< its distance from that point, in saved steps
    int first;     ///< of the saved points nearer than a spacing
    int last;

    Neighbours(double at, double reach, int count) {
        constexpr double kRounding = 1e-6; // in steps: coordinates of both grids are rounded
        if (const double nearest = std::round(at); std::abs(at - nearest) < kRounding)
            at = nearest;
        at = std::clamp(at, 0.0, count - 1.0);
        below = std::min(static_cast<int>(at), count - 2);
        beyond = at - below;
        first = static_cast<int>(std::max(0.0, std::floor(at - reach + kRounding) + 1));
        last = static_cast<int>(std::min(count - 1.0, std::ceil(at + reach - kRounding) - 1));
    }
};

float resampled(const ZMapSnapshot& map, const Neighbours& x, const Neighbours& y) {
    const auto at = [&](int di, int dj) {
        const int i = std::min(x.below + di, map.grid().nx - 1);
        const int j = std::min(y.below + dj, map.grid().ny - 1);
        return double{map.height(i, j)};
    };
    const double between =
        std::lerp(std::lerp(at(0, 0), at(1, 0), x.beyond), std::lerp(at(0, 1), at(1, 1), x.beyond), y.beyond);
    auto highest = static_cast<float>(between);
    for (int j = y.first; j <= y.last; ++j)
        for (int i = x.first; i <= x.last; ++i)
            highest = std::max(highest, map.height(i, j));
    return highest;
}

class SavedStock final : public StockBody, public PartedStock {
public:
    SavedStock(ZMapSnapshot map, double spacing, Undercut undercut)
        : m_map(std::move(map)), m_spacing(spacing), m_undercut(undercut), m_hasWalls(hasAny(m_map.rims())) {}

    [[nodiscard]] StockBox box() const override { return m_map.stock(); }
    [[nodiscard]] std::optional<double> spacing() const override { return m_spacing; }

    [[nodiscard]] UncutStock uncut(const StockBox& stock, const Grid& grid) const override {
        Undercut undercut = m_undercut;
        undercut.place += stock.corner - box().corner;
        const Grid& saved = m_map.grid();
        Diagnostics findings = undercut.reported();
        const bool isSame = hasGrid(stock, grid);
        const bool isFiner = isPartOf(saved.nx, grid.nx) && isPartOf(saved.ny, grid.ny);
        if (!isSame && !isFiner)
            findings.push_back(resamplingNote(grid));
        if (m_hasWalls && !hasWallsOn(stock, grid))
            findings.push_back(diagnosticOf(stock_body_finding::kStockWallsLost,
                                            {figures("{:.6g}", saved.hx), figures("{:.6g}", saved.hy)}));
        if (isSame)
            return {sameTiles(m_map, stock, grid), std::move(findings)};
        return {onOtherGrid(stock, GridPart(grid), grid), std::move(findings)};
    }
    [[nodiscard]] RimMap rims(const StockBox& stock, const Grid& grid) const override {
        if (!m_hasWalls)
            return {};
        return hasWallsOn(stock, grid) ? m_map.rims() : unknownRims(tileCountOf(grid));
    }
    [[nodiscard]] ZMap uncutPart(const StockBox& stock, const GridPart& part) const override {
        return onOtherGrid(part.stock(stock), part, part.grid());
    }
    [[nodiscard]] RimMap rimsOfPart(const StockBox& stock, const GridPart& part) const override {
        if (!m_hasWalls)
            return {};
        const Grid& saved = m_map.grid();
        const int i0 = static_cast<int>(part.firstI);
        const int j0 = static_cast<int>(part.firstJ);
        const bool isSame = stock.height == box().height && isSameSpacing(part.hx, saved.hx) &&
                            isSameSpacing(part.hy, saved.hy);
        return isSame ? rimsWithin(m_map, {i0, j0, i0 + part.nx, j0 + part.ny})
                      : unknownRims(tileCountOf(part.grid()));
    }

private:
    static constexpr double kSameSpacing = 1e-9; ///< but for rounding

    [[nodiscard]] bool hasGrid(const StockBox& stock, const Grid& grid) const {
        const Grid& saved = m_map.grid();
        return grid.nx == saved.nx && grid.ny == saved.ny && stock.height == box().height;
    }
    /// Whether its rims are those of that map.
    [[nodiscard]] bool hasWallsOn(const StockBox& stock, const Grid& grid) const {
        return hasGrid(stock, grid) && isSameSpacing(grid.hx, m_map.grid().hx) &&
               isSameSpacing(grid.hy, m_map.grid().hy);
    }
    static bool isSameSpacing(double a, double b) { return std::abs(a / b - 1) < kSameSpacing; }
    static bool isPartOf(int savedPoints, int points) { return (points - 1) % (savedPoints - 1) == 0; }

    /// `part`: where the points are in a grid over the whole stock.
    [[nodiscard]] ZMap onOtherGrid(const StockBox& stock, const GridPart& part, const Grid& grid) const {
        const Grid& saved = m_map.grid();
        std::vector<Neighbours> columns;
        std::vector<Neighbours> rows;
        columns.reserve(static_cast<std::size_t>(grid.nx));
        rows.reserve(static_cast<std::size_t>(grid.ny));
        for (int i = 0; i < grid.nx; ++i)
            columns.emplace_back(grid.hx * (part.firstI + i) / saved.hx, grid.hx / saved.hx, saved.nx);
        for (int j = 0; j < grid.ny; ++j)
            rows.emplace_back(grid.hy * (part.firstJ + j) / saved.hy, grid.hy / saved.hy, saved.ny);
        const auto floor = static_cast<float>(-stock.height);
        return mapOf(stock, grid, [&](int i, int j) {
            return std::max(floor, resampled(m_map, columns[static_cast<std::size_t>(i)],
                                             rows[static_cast<std::size_t>(j)]));
        });
    }

    [[nodiscard]] Diagnostic resamplingNote(const Grid& grid) const {
        return diagnosticOf(stock_body_finding::kStockResampled,
                            {figures("{:.6g}", m_map.grid().hx), figures("{:.6g}", m_map.grid().hy),
                             figures("{:.6g}", grid.hx), figures("{:.6g}", grid.hy)});
    }

    ZMapSnapshot m_map;
    double m_spacing;
    Undercut m_undercut; ///< in the body's own coordinates
    bool m_hasWalls;     ///< or ribs
};

} // namespace

Result<std::shared_ptr<const StockBody>> savedStock(const ZMapSnapshot& saved, double spacing, StockTurn turn,
                                                    StockFlip flip) {
    Undercut undercut;
    ZMapSnapshot map = saved;
    if (flip != StockFlip::none) {
        if (highestOf(map) <= map.floor())
            return failure(zmap_finding::kStockNothingLeft);
        map = turned(flipped(map, flip, undercut), turn);
        // The place of a gap turns with the stock.
        if (turn != StockTurn::none && undercut.tallest > 0) {
            const StockBox& box = map.stock();
            const double x = undercut.place.x - box.corner.x;
            const double y = undercut.place.y - box.corner.y;
            const Vec2 place = turn == StockTurn::quarter ? Vec2(box.width - y, x)
                               : turn == StockTurn::half  ? Vec2(box.width - x, box.depth - y)
                                                          : Vec2(y, box.depth - x);
            undercut.place.x = box.corner.x + place.x;
            undercut.place.y = box.corner.y + place.y;
        }
    } else {
        map = turned(map, turn);
    }
    return std::make_shared<const SavedStock>(std::move(map), spacing, undercut);
}

} // namespace proveout
