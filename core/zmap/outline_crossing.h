// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "core/base/geometry.h"

namespace proveout {

/// A part of the outline that rises or falls all the way: a line, or the left or right side of an arc.
struct OutlinePiece {
    Vec2 low{0};
    Vec2 high{0};
    Vec2 centre{0};
    double radius = 0; ///< 0 for a line
    double side = 0;   ///< of an arc: -1 left of its centre, +1 right of it

    /// A horizontal line at an end belongs to the piece above, so that each loop is crossed an even number of
    /// times.
    [[nodiscard]] bool crosses(double y) const { return y >= low.y && y < high.y; }
    [[nodiscard]] double crossing(double y) const {
        if (radius > 0)
            return centre.x +
                   side * std::sqrt(std::max(0.0, radius * radius - (y - centre.y) * (y - centre.y)));
        return std::lerp(low.x, high.x, (y - low.y) / (high.y - low.y));
    }
    /// A lower bound of the distance of a point from the piece.
    [[nodiscard]] double distance(const Vec2& place) const {
        if (radius > 0)
            return std::abs(glm::distance(place, centre) - radius);
        const Vec2 along = high - low;
        const double square = glm::dot(along, along);
        const double t = square > 0 ? std::clamp(glm::dot(place - low, along) / square, 0.0, 1.0) : 0;
        return glm::distance(place, low + along * t);
    }
};

/// Where two pieces cross; nothing if none cross by more than a micrometre. Needs n log n steps for n pieces.
/// Source: M. Shamos and D. Hoey, Geometric intersection problems, 1976.
[[nodiscard]] std::optional<Vec2> crossingOf(std::span<const OutlinePiece> pieces);

} // namespace proveout
