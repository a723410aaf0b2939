// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle of a mesh that is stock, over the rows of a grid. Internal to this library.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/base/geometry.h"

namespace proveout {

/// A point this near to a triangle in plan, in mm, counts as on its rim: coordinates of a grid are rounded.
inline constexpr double kOnRim = 1e-6;

using FacetCorners = std::array<Vec3, 3>;

/// Twice the area in plan; above 0 if the triangle faces up.
inline double areaInPlan(const FacetCorners& c) {
    return (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
}

/// Where a horizontal line crosses the edge: the result is the same for both triangles of the edge.
inline double crossingOf(const Vec3& a, const Vec3& b, double y) {
    const bool ordered = a.y < b.y || (a.y == b.y && a.x < b.x);
    const Vec3& low = ordered ? a : b;
    const Vec3& high = ordered ? b : a;
    return std::lerp(low.x, high.x, (y - low.y) / (high.y - low.y));
}

struct FacetRange {
    double from = std::numeric_limits<double>::infinity();
    double to = -std::numeric_limits<double>::infinity();

    void add(double x) {
        from = std::min(from, x);
        to = std::max(to, x);
    }
};

/// One triangle over the rows of the grid.
class Facet {
public:
    explicit Facet(const FacetCorners& corners)
        : m_corners(corners), m_area(areaInPlan(corners)),
          m_lowest(std::min({corners[0].z, corners[1].z, corners[2].z})),
          m_highest(std::max({corners[0].z, corners[1].z, corners[2].z})) {
        if (m_area == 0)
            return;
        const Vec3 u = corners[1] - corners[0];
        const Vec3 v = corners[2] - corners[0];
        m_slope = {(u.z * v.y - v.z * u.y) / m_area, (v.z * u.x - u.z * v.x) / m_area};
    }

    /// Whether the triangle is vertical. Such a triangle is not part of the upper or lower surface; the
    /// triangles at its edges are.
    [[nodiscard]] bool isUpright() const { return m_area == 0; }
    [[nodiscard]] bool looksUp() const { return m_area > 0; }
    [[nodiscard]] double highest() const { return m_highest; }
    [[nodiscard]] double leastX() const { return std::min({m_corners[0].x, m_corners[1].x, m_corners[2].x}); }
    [[nodiscard]] double largestX() const {
        return std::max({m_corners[0].x, m_corners[1].x, m_corners[2].x});
    }
    [[nodiscard]] double lowestY() const {
        return std::min({m_corners[0].y, m_corners[1].y, m_corners[2].y});
    }
    [[nodiscard]] double highestY() const {
        return std::max({m_corners[0].y, m_corners[1].y, m_corners[2].y});
    }

    [[nodiscard]] double heightAt(double x, double y) const {
        const double z = m_corners[0].z + m_slope.x * (x - m_corners[0].x) + m_slope.y * (y - m_corners[0].y);
        return std::clamp(z, m_lowest, m_highest);
    }
    /// The part of a horizontal line that the triangle covers, including its rim.
    [[nodiscard]] FacetRange covered(double y) const {
        FacetRange range;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& a = m_corners[k];
            const Vec3& b = m_corners[(k + 1) % 3];
            if (std::abs(a.y - y) <= kOnRim)
                range.add(a.x);
            if (std::min(a.y, b.y) < y && y < std::max(a.y, b.y))
                range.add(crossingOf(a, b, y));
        }
        return range;
    }
    /// The part of a horizontal line that belongs to this triangle alone: from the first end on, without the
    /// second.
    [[nodiscard]] FacetRange owned(double y) const {
        FacetRange range;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& a = m_corners[k];
            const Vec3& b = m_corners[(k + 1) % 3];
            if (std::min(a.y, b.y) <= y && y < std::max(a.y, b.y))
                range.add(crossingOf(a, b, y));
        }
        return range;
    }

private:
    FacetCorners m_corners;
    double m_area;
    double m_lowest;
    double m_highest;
    Vec2 m_slope{0};
};

} // namespace proveout
