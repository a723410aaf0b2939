// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/zmap.h"

#include <algorithm>

namespace proveout {

void Tile::refreshMaximum() {
    for (int block = 0; block < kBlocks * kBlocks; ++block) {
        const float* first = &heights[static_cast<std::size_t>(block / kBlocks * kBlockSize * kSize +
                                                               block % kBlocks * kBlockSize)];
        // Parallel lanes, so that the compiler can keep them in vector registers.
        std::array<float, kBlockSize> lanes;
        std::copy_n(first, kBlockSize, lanes.begin());
        for (int row = 1; row < kBlockSize; ++row) {
            for (std::size_t lane = 0; lane < kBlockSize; ++lane) {
                const float height = first[static_cast<std::size_t>(row * kSize) + lane];
                lanes[lane] = height > lanes[lane] ? height : lanes[lane];
            }
        }
        blockMaxima[static_cast<std::size_t>(block)] = *std::ranges::max_element(lanes);
    }
    updateMaximum();
    loweredPoints = 0;
}

void Tile::updateMaximum() {
    maximum = *std::ranges::max_element(blockMaxima);
}

} // namespace proveout
