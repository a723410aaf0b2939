// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/geometry.h"
#include "core/part/deviation.h"

namespace proveout {

enum class IslandKind : std::uint8_t { gouge, excess };
/// "gouge" or "excess".
[[nodiscard]] const char* name(IslandKind kind);

/// Neighbouring places of a part that are out of tolerance on the same side.
struct Island {
    IslandKind kind = IslandKind::gouge;
    double depthMm = 0;   ///< the largest deviation, without the allowance, positive for both kinds
    double areaMm2 = 0;   ///< over ground, and of steep faces
    double volumeMm3 = 0; ///< missing, or left
    Vec3 place{0};        ///< of the largest deviation, program coordinates
    bool isOnPart = true; ///< the place is on the part; false: on the stock
    int i = 0;            ///< the point of the grid that is nearest to it
    int j = 0;
    Vec2 lo{0}; ///< its box over ground
    Vec2 hi{0};
};

/// All of them, the deepest first; neighbours are points in rows, columns and diagonals. Any thread; needs
/// some 20 bytes for each point out of tolerance.
[[nodiscard]] std::vector<Island> islandsOf(const Deviation& deviation, const PartTolerance& tolerance);

} // namespace proveout
