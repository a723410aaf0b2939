// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <glm/glm.hpp>

#include "core/base/index_rect.h"
#include "core/zmap/stock.h"

namespace proveout {

/// How the points of a grid are divided into pages, the layers of a texture (resources/shaders/heights.glsl).
/// A grid that fits one texture is one page without a margin.
struct HeightPages {
    /// Shading reads the texture up to 2.1 points away from the page's own and interpolates there.
    static constexpr int kMargin = 3;

    glm::ivec2 points{0, 0}; ///< of one page, along x and y, without the margin
    int columns = 0;
    int rows = 0;
    int margin = 0; ///< points of neighbours on each side

    /// The fewest pages with at most `most` points along a side, margin included.
    [[nodiscard]] static HeightPages of(const Grid& grid, int most);

    /// Pages of `side` points along a side, and a margin.
    [[nodiscard]] static HeightPages ofSide(const Grid& grid, int side);

    [[nodiscard]] int count() const { return columns * rows; }
    [[nodiscard]] glm::ivec2 texels() const { return points + 2 * margin; } ///< of one layer
    [[nodiscard]] std::size_t bytes() const;                                ///< of all layers
    /// The points of the grid that a page holds, margin included.
    [[nodiscard]] IndexRect held(int column, int row, const Grid& grid) const;
    /// The pages that hold any of these points, as columns and rows.
    [[nodiscard]] IndexRect pagesAt(const IndexRect& rect) const;
};

} // namespace proveout
