// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this library.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/geometry.h"

namespace proveout {

/// Of a triangle, mm.
using Corners = std::array<Vec3, 3>;

/// As long as twice its area.
inline Vec3 normalOf(const Corners& corners) {
    return glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
}

/// By its first corner.
inline std::size_t longestSide(const Corners& corners) {
    const auto length2 = [&](std::size_t k) {
        const Vec3 side = corners[(k + 1) % 3] - corners[k];
        return glm::dot(side, side);
    };
    return std::ranges::max(std::array<std::size_t, 3>{0, 1, 2}, {}, length2);
}

/// Its height over its longest side, mm.
inline double flatness(const Corners& corners) {
    const std::size_t k = longestSide(corners);
    const double longest = glm::length(corners[(k + 1) % 3] - corners[k]);
    return longest > 0 ? glm::length(normalOf(corners)) / longest : 0;
}

/// Whether a triangle of a surface is turned over. Walls that are round overhang a little, and are not.
inline bool isTurnedOver(const Corners& corners) {
    constexpr double kOverhang = 0.5;
    const Vec3 normal = normalOf(corners);
    return normal.z < -kOverhang * glm::length(normal);
}

/// Whether a triangle is nearly level, whichever way it faces.
inline bool isLevel(const Corners& corners) {
    constexpr double kLevel = 0.99;
    const Vec3 normal = normalOf(corners);
    return std::abs(normal.z) >= kLevel * glm::length(normal);
}

} // namespace proveout
