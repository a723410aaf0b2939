// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "core/zmap/stock.h"
#include "ui/gl/height_pages.h"

namespace proveout {

/// A page that may be in the view.
struct VisiblePage {
    int page = 0;      ///< row by row
    double pixels = 0; ///< the most that a cell of the grid takes on the screen, along a side
};

/// How pages are seen, in stock coordinates.
struct PageView {
    glm::dmat4 clipFromStock{1};
    glm::ivec2 pixels{1, 1};
};

/// The part of a page that can be seen, mm above the floor of the stock.
struct PageHeights {
    double lowest = 0;
    double highest = 0;
};

/// The pages that are in the view, given the heights of each, those with the largest cells on the screen
/// first. A page beside the view may be among them, never one missing.
[[nodiscard]] std::vector<VisiblePage> visiblePages(const Grid& grid, const HeightPages& pages,
                                                    const std::vector<PageHeights>& heights,
                                                    const PageView& view);

/// Of the visible pages, the ones to be held in so many slots: all if they fit; else the first of those in
/// which the cells of a coarser grid would be larger than a pixel.
[[nodiscard]] std::vector<int> pagesToHold(const std::vector<VisiblePage>& visible, int coarseStep,
                                           std::size_t capacity);

} // namespace proveout
