// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lattice/region_patch.h"

#include <algorithm>
#include <cmath>

namespace proveout {

void RegionPatch::load(const RegionSamples& samples) {
    m_width = samples.rect.width();
    m_height = samples.rect.height();
    m_walls.assign(samples.walls.begin(), samples.walls.end());
    m_parity = (samples.rect.i0 + samples.rect.j0) & 1;
    m_stride = (m_width + 2 * kReadAhead - 1) / kReadAhead * kReadAhead;
    // One more row than the region has: a crossing at the last row is computed between it and the next one.
    const auto size =
        static_cast<std::size_t>(m_stride) * static_cast<std::size_t>(m_height + 1) + kReadAhead;
    if (m_heights.size() < size)
        m_heights.resize(size);
    const float base = samples.heights[0];
    float low = 0;
    float high = 0;
    const float* from = samples.heights.data();
    float* to = m_heights.data();
    for (int j = 0; j < m_height; ++j, from += m_width, to += m_stride) {
        for (int i = 0; i < m_width; ++i) {
            const float z = from[i] - base;
            to[i] = z;
            low = z < low ? z : low;
            high = z > high ? z : high;
        }
    }
    m_largest = std::max(-low, high);
}

} // namespace proveout
