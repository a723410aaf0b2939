// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this library.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

/// A closed line by the indices of its points.
using PlanLoop = std::vector<std::uint32_t>;

/// Triangles of a polygon, counter-clockwise, with all its points as vertices. The first loop is the outline,
/// counter-clockwise; the others are holes, clockwise, or single points inside. Nothing if the loops cross or
/// touch each other or themselves, or have so many points that it would take long (tens of thousands).
[[nodiscard]] std::optional<std::vector<std::array<std::uint32_t, 3>>>
triangulatePolygon(std::span<const Vec2> points, const std::vector<PlanLoop>& loops);

/// Twice the area of a loop, positive if it is counter-clockwise.
[[nodiscard]] double areaOf(std::span<const Vec2> points, const PlanLoop& loop);

/// Twice the area of a triangle, positive if it is counter-clockwise.
[[nodiscard]] inline double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

} // namespace proveout
