// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "core/base/geometry.h"

namespace proveout {

/// What of a triangle is nearest to a point: its inside, the side from corner k to the next one, or corner k.
enum class FacetFeature : std::uint8_t { inside, side0, side1, side2, corner0, corner1, corner2 };

struct NearestOnFacet {
    Vec3 place;
    FacetFeature feature;
};

/// Any triangle, also one without an area. Source: C. Ericson, Real-Time Collision Detection, 5.1.5.
[[nodiscard]] NearestOnFacet nearestOnFacet(const Vec3& point, const std::array<Vec3, 3>& corners);

} // namespace proveout
