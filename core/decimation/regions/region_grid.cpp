// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/region_grid.h"

#include <algorithm>
#include <cassert>

namespace proveout {

namespace {

/// Regions along an axis of `points` points; the last may be smaller.
int regionsAlong(int points, int cells) {
    return std::max(1, (points - 1 + cells - 1) / cells);
}

/// The regions [first, last) along an axis that contain one of the points [p0, p1). A point on a border
/// belongs to the regions on both sides.
std::array<int, 2> regionsHolding(int p0, int p1, int cells, int regions) {
    const int first = p0 <= 0 ? 0 : (p0 - 1) / cells;
    const int last = std::min((p1 - 1) / cells + 1, regions);
    return {std::min(first, regions), last};
}

} // namespace

RegionGrid::RegionGrid(int nx, int ny, int cells)
    : m_nx(nx), m_ny(ny), m_cells(std::max(1, cells)), m_regionsX(regionsAlong(nx, m_cells)),
      m_regionsY(regionsAlong(ny, m_cells)) {
    assert(nx >= 2 && ny >= 2);
}

std::size_t RegionGrid::regionCount() const {
    return static_cast<std::size_t>(m_regionsX) * static_cast<std::size_t>(m_regionsY);
}

// Borders along x come first, row by row from the south edge of the map to the north edge; then those along
// y, row of regions by row of regions, from west to east.
std::size_t RegionGrid::borderCount() const {
    const auto rx = static_cast<std::size_t>(m_regionsX);
    const auto ry = static_cast<std::size_t>(m_regionsY);
    return rx * (ry + 1) + (rx + 1) * ry;
}

IndexRect RegionGrid::points(std::size_t region) const {
    const int rx = static_cast<int>(region % static_cast<std::size_t>(m_regionsX));
    const int ry = static_cast<int>(region / static_cast<std::size_t>(m_regionsX));
    const int i0 = rx * m_cells;
    const int j0 = ry * m_cells;
    return {i0, j0, std::min(i0 + m_cells + 1, m_nx), std::min(j0 + m_cells + 1, m_ny)};
}

std::size_t RegionGrid::border(std::size_t region, Side side) const {
    const auto regionsX = static_cast<std::size_t>(m_regionsX);
    const std::size_t rx = region % regionsX;
    const std::size_t ry = region / regionsX;
    const std::size_t alongX = regionsX * (static_cast<std::size_t>(m_regionsY) + 1);
    switch (side) {
    case Side::south:
        return ry * regionsX + rx;
    case Side::north:
        return (ry + 1) * regionsX + rx;
    case Side::west:
        return alongX + ry * (regionsX + 1) + rx;
    case Side::east:
        break;
    }
    return alongX + ry * (regionsX + 1) + rx + 1;
}

std::array<std::size_t, 4> RegionGrid::borders(std::size_t region) const {
    std::array<std::size_t, 4> all{};
    std::transform(kSides.begin(), kSides.end(), all.begin(),
                   [&](Side side) { return border(region, side); });
    return all;
}

std::array<std::size_t, 2> RegionGrid::sharers(std::size_t border) const {
    const auto regionsX = static_cast<std::size_t>(m_regionsX);
    const auto regionsY = static_cast<std::size_t>(m_regionsY);
    const std::size_t alongX = regionsX * (regionsY + 1);
    std::size_t before = kNoRegion; // south or west of the border
    std::size_t after = kNoRegion;
    if (border < alongX) {
        const std::size_t row = border / regionsX;
        if (row > 0)
            before = border - regionsX;
        if (row < regionsY)
            after = border;
    } else {
        const std::size_t row = (border - alongX) / (regionsX + 1);
        const std::size_t column = (border - alongX) % (regionsX + 1);
        if (column > 0)
            before = row * regionsX + column - 1;
        if (column < regionsX)
            after = row * regionsX + column;
    }
    if (before == kNoRegion)
        return {after, kNoRegion};
    return {before, after};
}

IndexRect RegionGrid::borderPoints(std::size_t border) const {
    const auto [first, second] = sharers(border);
    const IndexRect rect = points(first);
    for (const Side side : kSides) {
        if (this->border(first, side) != border)
            continue;
        switch (side) {
        case Side::south:
            return {rect.i0, rect.j0, rect.i1, rect.j0 + 1};
        case Side::north:
            return {rect.i0, rect.j1 - 1, rect.i1, rect.j1};
        case Side::west:
            return {rect.i0, rect.j0, rect.i0 + 1, rect.j1};
        case Side::east:
            return {rect.i1 - 1, rect.j0, rect.i1, rect.j1};
        }
    }
    assert(false && "a border is a side of its sharer");
    return {};
}

IndexRect RegionGrid::regionsTouching(const IndexRect& rect) const {
    const IndexRect inside = intersection(rect, {0, 0, m_nx, m_ny});
    if (inside.empty())
        return {};
    const auto [rx0, rx1] = regionsHolding(inside.i0, inside.i1, m_cells, m_regionsX);
    const auto [ry0, ry1] = regionsHolding(inside.j0, inside.j1, m_cells, m_regionsY);
    return {rx0, ry0, rx1, ry1};
}

std::uint32_t firstSnappedUp(std::uint32_t a, std::uint32_t b, std::uint32_t n) {
    const std::uint32_t nearer = (a + b) / 2 + 1;
    // Beside a corner both borders must snap to the corner: if one of its two neighbours moved away along its
    // border, and the other along its own, the triangle between them would turn over.
    const bool endsInCorner = b == n && a + 1 < b;
    return endsInCorner ? std::min(nearer, n - 1) : nearer;
}

std::vector<std::uint32_t> snapToKept(const BorderLine& line, std::uint32_t n) {
    std::vector<std::uint32_t> target(n + 1, 0);
    for (std::size_t k = 0; k + 1 < line.kept.size(); ++k) {
        const std::uint32_t a = line.kept[k];
        const std::uint32_t b = line.kept[k + 1];
        const std::uint32_t split = firstSnappedUp(a, b, n);
        for (std::uint32_t offset = a; offset <= b; ++offset)
            target[offset] = offset < split ? a : b;
    }
    return target;
}

} // namespace proveout
