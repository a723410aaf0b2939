// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/decimation/regions/region_decimator.h"

namespace proveout {

/// The heights of one region in the layout of the certified method: relative to the region's first point, in
/// rows padded so that a whole vector can be read from any point. Owned by one decimator, allocated once.
class RegionPatch {
public:
    /// The widest vector that is read from a point: 64 bytes.
    static constexpr int kReadAhead = 16;

    void load(const RegionSamples& samples);

    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }
    [[nodiscard]] int stride() const { return m_stride; }
    [[nodiscard]] const float* heights() const { return m_heights.data(); }
    [[nodiscard]] float at(int i, int j) const { return m_heights[index(i, j)]; }
    /// The largest magnitude of a height, to which rounding is proportional.
    [[nodiscard]] double largest() const { return m_largest; }
    /// The possible difference of the float heights from the true ones, twice, and the rounding of a result.
    [[nodiscard]] double guard(double result) const {
        return (3 * m_largest + result) * double{std::numeric_limits<float>::epsilon()} / 2;
    }
    /// Points that stay vertices, as ascending offsets row by row.
    [[nodiscard]] std::span<const std::uint32_t> walls() const { return m_walls; }
    [[nodiscard]] bool isWall(int i, int j) const {
        return std::ranges::binary_search(m_walls, static_cast<std::uint32_t>(j * m_width + i));
    }
    /// A diagonal of the canonical mesh is where i + j (of the patch) plus this is even: 0 or 1.
    [[nodiscard]] int parity() const { return m_parity; }

private:
    [[nodiscard]] std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(m_stride) + static_cast<std::size_t>(i);
    }

    std::vector<float> m_heights;
    std::vector<std::uint32_t> m_walls;
    int m_width = 0;
    int m_height = 0;
    int m_stride = 0;
    int m_parity = 0;
    double m_largest = 0;
};

} // namespace proveout
