// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/part_top.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/parallel.h"

namespace proveout {

namespace {

constexpr int kRowsOfBand = 64;
constexpr double kOnOutline = 1e-9; // mm: a point so far outside of a facet is over it

/// Where a facet is over ground, and how high.
class FacetOverGround {
public:
    explicit FacetOverGround(const std::array<Vec3, 3>& corners) : m_corners(corners) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 along = Vec2(corners[(k + 2) % 3]) - Vec2(corners[(k + 1) % 3]);
            m_lengths[k] = glm::length(along);
        }
        m_area = areaBeside(2, Vec2(corners[2]));
        m_low = std::min({corners[0].z, corners[1].z, corners[2].z});
        m_high = std::max({corners[0].z, corners[1].z, corners[2].z});
    }

    [[nodiscard]] bool isUpright() const {
        return std::abs(m_area) <= kOnOutline * std::ranges::max(m_lengths);
    }
    /// kNone beside it.
    [[nodiscard]] double height(const Vec2& place) const {
        double sum = 0;
        double z = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double area = m_area > 0 ? areaBeside(k, place) : -areaBeside(k, place);
            if (area < -kOnOutline * m_lengths[k])
                return double{PartTop::kNone};
            sum += area;
            z += area * m_corners[k].z;
        }
        return std::clamp(z / sum, m_low, m_high);
    }

private:
    /// Of the triangle of a place and the side opposite of a corner, twice.
    [[nodiscard]] double areaBeside(std::size_t corner, const Vec2& place) const {
        const Vec2 from = Vec2(m_corners[(corner + 1) % 3]) - place;
        const Vec2 to = Vec2(m_corners[(corner + 2) % 3]) - place;
        return from.x * to.y - from.y * to.x;
    }

    std::array<Vec3, 3> m_corners;
    std::array<double, 3> m_lengths{}; ///< of the sides opposite of the corners
    double m_area = 0;
    double m_low = 0;
    double m_high = 0;
};

/// The points of a grid in one direction between two places.
struct Points {
    int first;
    int last; ///< behind the last one
};
Points between(double low, double high, double origin, double step, int count) {
    const double first = std::ceil((low - kOnOutline - origin) / step);
    const double last = std::floor((high + kOnOutline - origin) / step) + 1;
    return {static_cast<int>(std::clamp(first, 0.0, static_cast<double>(count))),
            static_cast<int>(std::clamp(last, 0.0, static_cast<double>(count)))};
}

Points rowsOf(const std::array<Vec3, 3>& corners, const Grid& grid) {
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    return between(low, high, grid.y0, grid.hy, grid.ny);
}

/// The facets over each band of rows.
std::vector<std::vector<std::uint32_t>> facetsOfBands(const DesignPart& part, const Grid& grid) {
    std::vector<std::vector<std::uint32_t>> bands(
        static_cast<std::size_t>((grid.ny + kRowsOfBand - 1) / kRowsOfBand));
    for (std::size_t facet = 0; facet < part.mesh().triangles.size(); ++facet) {
        const Points rows = rowsOf(part.corners(facet), grid);
        for (int band = rows.first / kRowsOfBand; band * kRowsOfBand < rows.last; ++band)
            bands[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(facet));
    }
    return bands;
}

} // namespace

PartTop::PartTop(const DesignPart& part, const StockBox& stock, const Grid& grid)
    : m_nx(grid.nx), m_heights(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny), kNone) {
    const auto bands = facetsOfBands(part, grid);
    inParallel(bands.size(), [&](std::size_t band) {
        const int firstRow = static_cast<int>(band) * kRowsOfBand;
        for (const std::uint32_t facet : bands[band])
            add(part, facet, grid, stock.topZ(), firstRow, firstRow + kRowsOfBand);
    });
}

void PartTop::add(const DesignPart& part, std::size_t facet, const Grid& grid, double zero, int firstRow,
                  int lastRow) {
    const std::array<Vec3, 3> corners = part.corners(facet);
    const FacetOverGround over(corners);
    if (over.isUpright())
        return;
    const Points rows = rowsOf(corners, grid);
    const auto [low, high] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const Points columns = between(low, high, grid.x0, grid.hx, grid.nx);
    for (int j = std::max(rows.first, firstRow); j < std::min(rows.last, lastRow); ++j)
        for (int i = columns.first; i < columns.last; ++i) {
            float& height = m_heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(m_nx) +
                                      static_cast<std::size_t>(i)];
            const double found = over.height({grid.x(i), grid.y(j)});
            height = std::max(height, static_cast<float>(found - zero));
        }
}

} // namespace proveout
