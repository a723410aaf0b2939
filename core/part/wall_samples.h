// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this room.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/part/place_judge.h"

namespace proveout {

/// At samples of steep faces.
class WallSamples {
public:
    static constexpr double kMostSamples = 500'000; ///< more are not taken

    WallSamples(const MapDistance& map, const DesignPart& part, const PartTolerance& tolerance)
        : m_map(map), m_part(part), m_tolerance(tolerance) {
        double area = 0;
        for (std::size_t facet = 0; facet < part.mesh().triangles.size(); ++facet)
            if (const double own = areaOf(facet); own > 0) {
                m_facets.push_back(static_cast<std::uint32_t>(facet));
                area += own;
            }
        const Grid& grid = map.zmap().grid();
        m_spacing = std::max(std::min(grid.hx, grid.hy), std::sqrt(area / kMostSamples));
    }

    /// What may be out of tolerance.
    struct OfFacets {
        std::vector<WallDeviation> walls;
        std::vector<PartPlace> candidates; ///< the same places
        double hiddenMm2 = 0;
    };
    void look(std::size_t first, std::size_t last, OfFacets& out) const {
        for (std::size_t k = first; k < last; ++k)
            eachSample(m_facets[k],
                       [&](const Vec3& place, double areaMm2) { lookAt(m_facets[k], place, areaMm2, out); });
    }
    [[nodiscard]] std::size_t facets() const { return m_facets.size(); }
    [[nodiscard]] double spacing() const { return m_facets.empty() ? 0 : m_spacing; }

private:
    /// Faces are upright down to here, some 1°; below they face downwards.
    static constexpr double kUprightNormal = -0.02;
    /// Facets that are not as wide may lie between the points.
    static constexpr double kNarrowCells = 2;
    /// The slope up to which the map is exact between its points.
    static constexpr double kGentle = 1;
    /// Of a cell: a place so near to the border is on it.
    static constexpr double kOnBorder = 1e-3;

    [[nodiscard]] Vec3 normalOf(std::size_t facet) const {
        const std::array<Vec3, 3> at = m_part.corners(facet);
        return glm::cross(at[1] - at[0], at[2] - at[0]) / 2.0;
    }
    /// 0 if it faces downwards, or is neither steep nor so narrow that points of the grid may miss it.
    [[nodiscard]] double areaOf(std::size_t facet) const {
        const Vec3 normal = normalOf(facet);
        const double area = glm::length(normal);
        if (area == 0 || normal.z < kUprightNormal * area)
            return 0;
        const std::array<Vec3, 3> at = m_part.corners(facet);
        const double longest =
            std::max({glm::distance(at[0], at[1]), glm::distance(at[1], at[2]), glm::distance(at[2], at[0])});
        const Grid& grid = m_map.zmap().grid();
        const bool isNarrow = 2 * area / longest < kNarrowCells * std::max(grid.hx, grid.hy);
        return normal.z < kSteepNormal * area || isNarrow ? area : 0;
    }

    /// In rows along the longest side.
    template<class Visit>
    void eachSample(std::size_t facet, const Visit& visit) const {
        std::array<Vec3, 3> at = m_part.corners(facet);
        const auto side = [&](std::size_t k) { return glm::distance(at[k], at[(k + 1) % 3]); };
        const std::size_t longest = side(0) >= side(1) && side(0) >= side(2) ? 0 : side(1) >= side(2) ? 1 : 2;
        std::rotate(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(longest), at.end());
        const double area = glm::length(normalOf(facet));
        const double length = side(0);
        const auto steps = [this](double size) {
            return std::max(1, static_cast<int>(std::ceil(size / m_spacing)));
        };
        const int rows = steps(2 * area / length);
        // With the edges: what is left along one is often thinner than the rows are apart.
        for (int row = 0; row <= rows; ++row) {
            const double part = static_cast<double>(row) / rows;
            const double begin = std::max(part - 0.5 / rows, 0.0);
            const double end = std::min(part + 0.5 / rows, 1.0);
            const int samples = steps(length * (1 - part));
            const double areaOfRow = area * ((1 - begin) * (1 - begin) - (1 - end) * (1 - end));
            const Vec3 first = glm::mix(at[0], at[2], part);
            const Vec3 last = glm::mix(at[1], at[2], part);
            for (int k = 0; k <= samples; ++k)
                visit(glm::mix(first, last, static_cast<double>(k) / samples),
                      areaOfRow / samples * (k == 0 || k == samples ? 0.5 : 1));
        }
    }

    void lookAt(std::size_t facet, const Vec3& place, double areaMm2, OfFacets& out) const {
        const ZMapSnapshot& zmap = m_map.zmap();
        const Grid& grid = zmap.grid();
        const double x = (place.x - grid.x0) / grid.hx;
        const double y = (place.y - grid.y0) / grid.hy;
        if (x < 0 || y < 0 || x > grid.nx - 1 || y > grid.ny - 1 ||
            place.z < zmap.stock().floorZ() - kExactVolume)
            return; // beside the stock, or below it: told as such
        if (isSeenAlong(facet, place, x, y))
            return;
        const auto nearest = m_map.nearest(place, std::numeric_limits<double>::infinity());
        if (!nearest)
            return;
        const double value = nearest->isInside ? nearest->distance : -nearest->distance;
        const double off = value - m_tolerance.allowance;
        const double uncertain = nearest->isExact ? 0 : kUncertainCells * std::max(grid.hx, grid.hy);
        if (off + uncertain <= m_tolerance.above && off - uncertain >= -m_tolerance.below)
            return;
        const bool isOnBorder =
            x < kOnBorder || y < kOnBorder || x > grid.nx - 1 - kOnBorder || y > grid.ny - 1 - kOnBorder;
        if (off < 0 && value >= -m_tolerance.below && isOnBorder)
            return; // the stock has no allowance on its own sides
        if (off > 0 && isHidden(facet, place)) {
            out.hiddenMm2 += areaMm2;
            return;
        }
        out.walls.push_back({place, static_cast<float>(value), static_cast<float>(areaMm2),
                             static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y))});
        out.candidates.push_back({place, glm::normalize(normalOf(facet)), off, uncertain});
    }

    /// Whether a place of a face that is not steep is in tolerance along Z already, which is quick to know.
    [[nodiscard]] bool isSeenAlong(std::size_t facet, const Vec3& place, double x, double y) const {
        const Vec3 normal = normalOf(facet);
        if (normal.z < kSteepNormal * glm::length(normal) || m_tolerance.allowance != 0)
            return false;
        const ZMapSnapshot& zmap = m_map.zmap();
        const int i = std::min(static_cast<int>(x), zmap.grid().nx - 2);
        const int j = std::min(static_cast<int>(y), zmap.grid().ny - 2);
        const auto height = [&](int column, int row) {
            return static_cast<double>(zmap.height(i + column, j + row));
        };
        const double a = height(0, 0);
        const double b = height(1, 0);
        const double c = height(0, 1);
        const double d = height(1, 1);
        // On a wall in the cell the surface is elsewhere.
        if (std::max({a, b, c, d}) - std::min({a, b, c, d}) >
            kGentle * std::min(zmap.grid().hx, zmap.grid().hy))
            return false;
        const double u = x - i;
        const double v = y - j;
        // The diagonals of the canonical mesh end at points whose indices have an even sum.
        const double surface = (i + j) % 2 == 0
                                   ? (u >= v ? a + u * (b - a) + v * (d - b) : a + v * (c - a) + u * (d - c))
                               : u + v <= 1 ? a + u * (b - a) + v * (c - a)
                                            : d + (1 - u) * (c - d) + (1 - v) * (b - d);
        const double off = surface - (place.z - zmap.stock().topZ());
        return off <= m_tolerance.above && off >= -m_tolerance.below;
    }

    /// Whether other parts of the part are above the air in front of a place, farther than is allowed to be
    /// left there.
    [[nodiscard]] bool isHidden(std::size_t facet, const Vec3& place) const {
        const Vec3 normal = normalOf(facet);
        const double inFront = std::max(m_tolerance.above + m_tolerance.allowance, 0.0) + kExactVolume;
        return m_part.distance().isBelow(place + normal / glm::length(normal) * inFront);
    }

    const MapDistance& m_map;
    const DesignPart& m_part;
    const PartTolerance& m_tolerance;
    std::vector<std::uint32_t> m_facets;
    double m_spacing = 1;
};

} // namespace proveout
