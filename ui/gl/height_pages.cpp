// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/height_pages.h"

#include <algorithm>

namespace proveout {

HeightPages HeightPages::of(const Grid& grid, int most) {
    const auto countFor = [](int total, int usable) { return (total + usable - 1) / usable; };
    HeightPages pages;
    pages.margin = grid.nx <= most && grid.ny <= most ? 0 : kMargin;
    const int usable = std::max(most - 2 * pages.margin, 1);
    pages.columns = countFor(grid.nx, usable);
    pages.rows = countFor(grid.ny, usable);
    pages.points = {countFor(grid.nx, pages.columns), countFor(grid.ny, pages.rows)};
    return pages;
}

HeightPages HeightPages::ofSide(const Grid& grid, int side) {
    HeightPages pages;
    pages.margin = kMargin;
    pages.points = {side, side};
    pages.columns = (grid.nx + side - 1) / side;
    pages.rows = (grid.ny + side - 1) / side;
    return pages;
}

std::size_t HeightPages::bytes() const {
    return sizeof(float) * static_cast<std::size_t>(texels().x) * static_cast<std::size_t>(texels().y) *
           static_cast<std::size_t>(count());
}

IndexRect HeightPages::held(int column, int row, const Grid& grid) const {
    return {std::max(column * points.x - margin, 0), std::max(row * points.y - margin, 0),
            std::min((column + 1) * points.x + margin, grid.nx),
            std::min((row + 1) * points.y + margin, grid.ny)};
}

IndexRect HeightPages::pagesAt(const IndexRect& rect) const {
    return {std::max(rect.i0 - margin, 0) / points.x, std::max(rect.j0 - margin, 0) / points.y,
            std::min((rect.i1 - 1 + margin) / points.x + 1, columns),
            std::min((rect.j1 - 1 + margin) / points.y + 1, rows)};
}

} // namespace proveout
