// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

/// Gives points with equal float32 coordinates one index (-0 equals 0), in the order of their first
/// appearance. Open addressing: a facet soup of a million triangles welds in a fraction of a second.
class VertexWelder {
public:
    explicit VertexWelder(std::size_t expectedPoints);

    [[nodiscard]] std::uint32_t index(const std::array<float, 3>& point);
    /// The points, as exact doubles; the welder is empty afterwards.
    [[nodiscard]] std::vector<Vec3> releaseVertices();

private:
    [[nodiscard]] std::size_t slotOf(const std::array<float, 3>& point) const;
    void grow();

    std::vector<std::array<float, 3>> m_points;
    std::vector<std::uint32_t> m_slots; ///< their number is a power of two
};

} // namespace proveout
