// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/region_mesh.h"

namespace proveout {

namespace {

/// The lattice index of each point of a region, row by row, after its borders are drawn as their polylines.
std::vector<std::uint32_t> snappedPoints(const RegionGrid& grid, const IndexRect& rect,
                                         const std::array<BorderLinePtr, 4>& borders) {
    const auto width = static_cast<std::size_t>(rect.width());
    std::vector<std::uint32_t> points;
    points.reserve(width * static_cast<std::size_t>(rect.height()));
    for (int j = rect.j0; j < rect.j1; ++j)
        for (int i = rect.i0; i < rect.i1; ++i)
            points.push_back(grid.lattice(i, j));

    const auto at = [&](int i, int j) -> std::uint32_t& {
        return points[static_cast<std::size_t>(j - rect.j0) * width + static_cast<std::size_t>(i - rect.i0)];
    };
    for (const Side side : kSides) {
        const BorderLinePtr& line = borders[static_cast<std::size_t>(side)];
        if (!line)
            continue;
        const bool alongX = side == Side::south || side == Side::north;
        const int n = (alongX ? rect.width() : rect.height()) - 1;
        const int i0 = side == Side::east ? rect.i1 - 1 : rect.i0;
        const int j0 = side == Side::north ? rect.j1 - 1 : rect.j0;
        const std::vector<std::uint32_t> target = snapToKept(*line, static_cast<std::uint32_t>(n));
        for (int k = 1; k < n; ++k) {
            const int to = static_cast<int>(target[static_cast<std::size_t>(k)]);
            if (alongX)
                at(i0 + k, j0) = grid.lattice(i0 + to, j0);
            else
                at(i0, j0 + k) = grid.lattice(i0, j0 + to);
        }
    }
    return points;
}

} // namespace

std::vector<LatticeTriangle> fullRegionMesh(const RegionGrid& grid, std::size_t region,
                                            const std::array<BorderLinePtr, 4>& borders) {
    const IndexRect rect = grid.points(region);
    const std::vector<std::uint32_t> points = snappedPoints(grid, rect, borders);
    std::vector<LatticeTriangle> triangles;
    triangles.reserve(fullRegionFaces(grid, region, borders));
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a)
            triangles.push_back({a, b, c});
    };
    const auto width = static_cast<std::size_t>(rect.width());
    std::size_t corner = 0; // the south-west point of the cell
    for (int j = rect.j0; j + 1 < rect.j1; ++j, ++corner) {
        for (int i = rect.i0; i + 1 < rect.i1; ++i, ++corner) {
            const std::uint32_t southWest = points[corner];
            const std::uint32_t southEast = points[corner + 1];
            const std::uint32_t northWest = points[corner + width];
            const std::uint32_t northEast = points[corner + width + 1];
            if ((i + j) % 2 == 0) {
                add(southWest, southEast, northEast);
                add(southWest, northEast, northWest);
            } else {
                add(southWest, southEast, northWest);
                add(southEast, northEast, northWest);
            }
        }
    }
    return triangles;
}

std::size_t fullRegionFaces(const RegionGrid& grid, std::size_t region,
                            const std::array<BorderLinePtr, 4>& borders) {
    const IndexRect rect = grid.points(region);
    const auto cellsX = static_cast<std::size_t>(rect.width() - 1);
    const auto cellsY = static_cast<std::size_t>(rect.height() - 1);
    std::size_t faces = 2 * cellsX * cellsY;
    // A removed border point removes one triangle with it (paper, Fig. 6).
    for (const Side side : kSides) {
        if (const BorderLinePtr& line = borders[static_cast<std::size_t>(side)]) {
            const bool alongX = side == Side::south || side == Side::north;
            faces -= (alongX ? cellsX : cellsY) + 1 - line->kept.size();
        }
    }
    return faces;
}

} // namespace proveout
