// SPDX-License-Identifier: GPL-3.0-or-later
// Points, vectors and boxes. All lengths in mm, all angles in radians.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace proveout {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

/// An axis-parallel box; empty until the first point is added.
struct Box3 {
    Vec3 lo{std::numeric_limits<double>::infinity()};
    Vec3 hi{-std::numeric_limits<double>::infinity()};

    void add(const Vec3& point) {
        lo = glm::min(lo, point);
        hi = glm::max(hi, point);
    }
    void add(const Box3& other) {
        lo = glm::min(lo, other.lo);
        hi = glm::max(hi, other.hi);
    }
    [[nodiscard]] bool empty() const { return lo.x > hi.x; }
};

} // namespace proveout
