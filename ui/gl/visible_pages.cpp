// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/visible_pages.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>

namespace proveout {

namespace {

/// The side planes of the view, and the plane of the eye.
std::array<double, 5> insideOf(const glm::dvec4& clip) {
    return {clip.w + clip.x, clip.w - clip.x, clip.w + clip.y, clip.w - clip.y, clip.w};
}

/// The least distance from the eye, as w, of a box that may be in the view; nothing if it is outside.
std::optional<double> nearestInView(const glm::dvec3& lo, const glm::dvec3& hi, const glm::dmat4& clipFrom) {
    std::array<bool, 5> someInside{};
    double nearest = std::numeric_limits<double>::max();
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at((corner & 1U) != 0 ? hi.x : lo.x, (corner & 2U) != 0 ? hi.y : lo.y,
                            (corner & 4U) != 0 ? hi.z : lo.z);
        const glm::dvec4 clip = clipFrom * glm::dvec4(at, 1);
        const std::array<double, 5> inside = insideOf(clip);
        for (std::size_t plane = 0; plane < inside.size(); ++plane)
            someInside[plane] = someInside[plane] || inside[plane] >= 0;
        nearest = std::min(nearest, clip.w);
    }
    if (std::ranges::find(someInside, false) != someInside.end())
        return {};
    return nearest;
}

} // namespace

std::vector<VisiblePage> visiblePages(const Grid& grid, const HeightPages& pages,
                                      const std::vector<PageHeights>& heights, const PageView& view) {
    constexpr double kNearest = 1e-6; // a page around the eye
    const glm::dmat4& clip = view.clipFromStock;
    // The second row of the matrix: how fast the picture's vertical coordinate changes per mm.
    const double perMm = glm::length(glm::dvec3(clip[0][1], clip[1][1], clip[2][1]));
    const double scale = 0.5 * view.pixels.y * perMm * std::max(grid.hx, grid.hy);
    const int around = pages.margin; // shading and the triangles at its edge reach there
    std::vector<VisiblePage> visible;
    for (int row = 0; row < pages.rows; ++row)
        for (int column = 0; column < pages.columns; ++column) {
            const int page = row * pages.columns + column;
            const PageHeights& height = heights[static_cast<std::size_t>(page)];
            const glm::dvec3 lo(grid.hx * (column * pages.points.x - around),
                                grid.hy * (row * pages.points.y - around), height.lowest);
            const glm::dvec3 hi(grid.hx * ((column + 1) * pages.points.x + around),
                                grid.hy * ((row + 1) * pages.points.y + around), height.highest);
            if (const auto w = nearestInView(lo, hi, clip))
                visible.push_back({page, scale / std::max(*w, kNearest)});
        }
    std::ranges::stable_sort(visible, std::greater<>(), &VisiblePage::pixels);
    return visible;
}

std::vector<int> pagesToHold(const std::vector<VisiblePage>& visible, int coarseStep, std::size_t capacity) {
    std::vector<int> pages;
    for (const VisiblePage& page : visible)
        if (visible.size() <= capacity || (page.pixels * coarseStep > 1 && pages.size() < capacity))
            pages.push_back(page.page);
    return pages;
}

} // namespace proveout
