// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this library.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/decimation/solid/corners.h"

namespace proveout {

/// Whether a triangle is partly on the slope and partly on the level that meet in one of its points, so that
/// it leads across their crease. `uphill`: by point, SolidFrame::wallNormal().
inline bool isAcrossCrease(const Corners& corners, const std::array<Vec2, 3>& uphill, double cell) {
    constexpr double kAcross = 0.05; // of a cell, on either side
    if (isLevel(corners))
        return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto beside = [&](std::size_t other) {
            return glm::dot(Vec2(corners[other]) - Vec2(corners[k]), uphill[k]);
        };
        const auto [low, high] = std::minmax({beside((k + 1) % 3), beside((k + 2) % 3)});
        if (low < -kAcross * cell && high > kAcross * cell)
            return true;
    }
    return false;
}

} // namespace proveout
