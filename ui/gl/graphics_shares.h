// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>

#include "core/zmap/stock.h"

namespace proveout {

/// The limits of the textures of a graphics driver.
struct TextureLimits {
    int side = 1; ///< points along a side of a texture
    int layers = 1;
    /// Of one texture, which is created in one piece.
    std::size_t bytes = std::numeric_limits<std::size_t>::max();
};

/// How a number of bytes of graphics memory is divided where it cannot hold all heights of a grid. All in
/// bytes, unless said otherwise; together they never exceed that number.
struct GraphicsShares {
    int coarseStep = 2;        ///< of the coarser points that are always held
    std::size_t coarse = 0;    ///< for them
    std::size_t lists = 0;     ///< for the triangles of the surface
    std::size_t walls = 0;     ///< for the triangles of the outside walls
    std::size_t vertices = 0;  ///< for the heights of the vertices of the decimated meshes
    int pagePoints = 0;        ///< along a side of a page, without its margin
    std::size_t pages = 0;     ///< for pages with all points
    std::size_t slotCount = 0; ///< pages that these bytes hold

    [[nodiscard]] static GraphicsShares of(const Grid& grid, std::size_t bytes, const TextureLimits& limits);
    /// Of all outside walls of a stock, with every point.
    [[nodiscard]] static std::size_t mostWallBytes(const Grid& grid);
    /// Bytes of one page.
    [[nodiscard]] std::size_t pageBytes() const;
};

} // namespace proveout
