// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this library.
#pragma once

#include "core/base/geometry.h"

namespace proveout {

/// An area in plan, mm, program coordinates.
struct PlanArea {
    Vec2 lo;
    Vec2 hi;

    /// Cutters a little beside it may have cut a point in single precision.
    [[nodiscard]] bool meets(const PlanArea& other) const {
        constexpr double kNear = 1e-4; // mm
        return other.lo.x <= hi.x + kNear && other.hi.x >= lo.x - kNear && other.lo.y <= hi.y + kNear &&
               other.hi.y >= lo.y - kNear;
    }
    [[nodiscard]] bool meets(const Box3& box) const { return meets({Vec2(box.lo), Vec2(box.hi)}); }
};

} // namespace proveout
