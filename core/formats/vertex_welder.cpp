// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/vertex_welder.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace proveout {

namespace {

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();

std::uint64_t hashOf(const std::array<float, 3>& point) {
    std::uint64_t hash = 0;
    for (const float value : point) {
        hash ^= std::bit_cast<std::uint32_t>(value);
        hash *= 0x9e3779b97f4a7c15U; // the golden ratio spreads the points of grids, whose low bits are all
                                     // alike
        hash ^= hash >> 32;
    }
    return hash;
}

} // namespace

VertexWelder::VertexWelder(std::size_t expectedPoints)
    : m_slots(std::bit_ceil(std::max<std::size_t>(16, 2 * expectedPoints)), kFree) {}

/// The slot that holds the point, or the free one for it.
std::size_t VertexWelder::slotOf(const std::array<float, 3>& point) const {
    const std::size_t mask = m_slots.size() - 1;
    std::size_t slot = hashOf(point) & mask;
    while (m_slots[slot] != kFree && m_points[m_slots[slot]] != point)
        slot = (slot + 1) & mask;
    return slot;
}

void VertexWelder::grow() {
    m_slots.assign(m_slots.size() * 2, kFree);
    for (std::uint32_t i = 0; i < m_points.size(); ++i)
        m_slots[slotOf(m_points[i])] = i;
}

std::uint32_t VertexWelder::index(const std::array<float, 3>& point) {
    // Adding zero turns -0 into 0: equal points must have equal bits.
    const std::array<float, 3> key{point[0] + 0.0F, point[1] + 0.0F, point[2] + 0.0F};
    if (m_points.size() * 2 >= m_slots.size())
        grow();
    auto& slot = m_slots[slotOf(key)];
    if (slot == kFree) {
        slot = static_cast<std::uint32_t>(m_points.size());
        m_points.push_back(key);
    }
    return slot;
}

std::vector<Vec3> VertexWelder::releaseVertices() {
    std::vector<Vec3> vertices;
    vertices.reserve(m_points.size());
    for (const auto& point : m_points)
        vertices.emplace_back(point[0], point[1], point[2]);
    m_points.clear();
    std::fill(m_slots.begin(), m_slots.end(), kFree);
    return vertices;
}

} // namespace proveout
