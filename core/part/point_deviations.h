// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this room.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/part/place_judge.h"

namespace proveout {

/// At the points of the grid.
class PointDeviations {
public:
    PointDeviations(const MapDistance& map, const DesignPart& part, const PartTop& top,
                    const PartTolerance& tolerance)
        : m_map(map), m_part(part), m_top(top), m_tolerance(tolerance) {}

    struct Found {
        double value = 0;
        bool isOnPart = false;
        bool isJudged = false;
        bool hasSide = true;
        bool isPlain = false; ///< that of a slope, which is not much less in the other direction
        double ofStock = 0;   ///< the value of the stock's point alone
        bool isExact = true;  ///< as MapDistance::Nearest
    };
    /// That of the face of the part, where it can be reached from above.
    [[nodiscard]] Vec3 normalAt(const Vec3& place) const {
        const std::array<Vec3, 3> at = m_part.corners(m_part.distance().at(place)->facet);
        const Vec3 normal = glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0]));
        return normal.z < kSteepNormal ? Vec3(0, 0, 1) : normal;
    }

    [[nodiscard]] Found at(int i, int j) const {
        const double top = double{m_top.at(i, j)};
        if (top == double{PartTop::kNone})
            return {};
        const ZMapSnapshot& zmap = m_map.zmap();
        const double left = double{zmap.height(i, j)} - top; // stock over the part
        Found found = fromStock(i, j, left);
        const bool isUncutTop = static_cast<double>(zmap.height(i, j)) >= -kSameHeight;
        if (isUncutTop && found.value < m_tolerance.allowance && found.value >= -m_tolerance.below) {
            found.value = m_tolerance.allowance; // the stock has no allowance on its own top
            return found;
        }
        const bool isWithin = isAllowed(left) && isAllowed(found.value);
        if (isWithin || (found.isPlain && !isAllowed(found.value)))
            return found;
        // The other direction: this place of the part may be farther from the stock.
        const Grid& grid = zmap.grid();
        const Vec3 place(grid.x(i), grid.y(j), zmap.stock().topZ() + top);
        const auto nearest = m_map.nearest(place, atMost(std::abs(left)));
        const double away = nearest ? nearest->distance : std::abs(left);
        if (away > std::abs(found.value))
            found = {std::copysign(away, left),   true, true, true, false, found.value,
                     !nearest || nearest->isExact};
        return found;
    }

private:
    /// The distance along Z may be so much longer than by the slope.
    static constexpr double kAlongSlope = 1.1;

    /// A bound that rounding does not make too small.
    [[nodiscard]] static double atMost(double distance) { return distance * (1 + 1e-9) + 1e-6; }
    [[nodiscard]] bool isAllowed(double value) const {
        const double off = value - m_tolerance.allowance;
        return off <= m_tolerance.above && off >= -m_tolerance.below;
    }

    /// The normal distance of the stock's point.
    [[nodiscard]] Found fromStock(int i, int j, double left) const {
        const ZMapSnapshot& zmap = m_map.zmap();
        const Grid& grid = zmap.grid();
        const Vec3 point(grid.x(i), grid.y(j), zmap.stock().topZ() + double{zmap.height(i, j)});
        const auto place = m_part.distance().at(point, atMost(std::abs(left)));
        if (!place)
            return {left, false, true, true, false, left, true};
        Found found{place->distance, false, true, true, isOfSlope(*place, left), place->distance, true};
        const bool isSame = std::abs(place->distance) <= kSameHeight;
        // Over the highest place of the part no point is within it. Below, a point outside is beneath an
        // overhang that is gone, or on a wall: the other direction tells.
        const bool contradicts = left > kSameHeight && place->distance < -kSameHeight;
        if (!isSame && (!place->hasSide || contradicts))
            return {std::copysign(std::abs(place->distance), left), false, true, false, false, 0, true};
        if (left < -kSameHeight && place->distance > 0)
            found.value = 0;
        return found;
    }

    /// Whether the nearest place is on a face upwards, and no nearer than its slope makes it.
    [[nodiscard]] bool isOfSlope(const PartDistance::Place& place, double left) const {
        const std::array<Vec3, 3> at = m_part.corners(place.facet);
        const Vec3 normal = glm::cross(at[1] - at[0], at[2] - at[0]);
        return normal.z >= kSteepNormal * glm::length(normal) &&
               std::abs(left) * kSteepNormal <= kAlongSlope * std::abs(place.distance);
    }

    const MapDistance& m_map;
    const DesignPart& m_part;
    const PartTop& m_top;
    const PartTolerance& m_tolerance;
};

} // namespace proveout
