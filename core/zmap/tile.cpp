// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/zmap.h"

#include <algorithm>

namespace proveout {

void Tile::refreshMaximum() {
    // Lanes side by side, so that the compiler can keep them in vector registers.
    constexpr std::size_t kLanes = 32;
    static_assert((std::size_t{kSize} * kSize) % kLanes == 0);
    std::array<float, kLanes> lanes;
    std::copy_n(heights.begin(), kLanes, lanes.begin());
    for (std::size_t i = kLanes; i < heights.size(); i += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            lanes[lane] = heights[i + lane] > lanes[lane] ? heights[i + lane] : lanes[lane];
    }
    maximum = *std::max_element(lanes.begin(), lanes.end());
    loweredPoints = 0;
}

} // namespace proveout
