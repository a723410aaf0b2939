// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/point_table.h"

#include <algorithm>
#include <bit>

namespace proveout {

void PointTable::reset(std::size_t bytes) {
    const std::size_t count = std::max(std::bit_floor(bytes / sizeof(Entry)), kRow);
    m_entries.assign(count, {});
    m_changed.assign(rows(), true);
    m_used = 0;
    m_shift = 32 - std::countr_zero(count);
}

void PointTable::clear() {
    if (empty())
        return;
    std::ranges::fill(m_entries, Entry{});
    m_changed.assign(rows(), true);
    m_used = 0;
}

std::size_t PointTable::placeOf(std::uint32_t point) const {
    std::size_t place = (point * kHashFactor) >> m_shift;
    while (m_entries[place].point != point && m_entries[place].point != kNoPoint)
        place = (place + 1) & (m_entries.size() - 1);
    return place;
}

void PointTable::put(std::size_t place, std::uint32_t point, float height) {
    if (m_entries[place].point == point && m_entries[place].height == height)
        return;
    m_entries[place] = {point, height};
    m_changed[place / kRow] = true;
}

bool PointTable::add(std::uint32_t point, float height) {
    const std::size_t place = placeOf(point);
    if (m_entries[place].point == kNoPoint) {
        if (2 * m_used >= m_entries.size()) // beyond that, searches become long
            return false;
        ++m_used;
    }
    put(place, point, height);
    return true;
}

void PointTable::set(std::uint32_t point, float height) {
    if (const std::size_t place = placeOf(point); m_entries[place].point == point)
        put(place, point, height);
}

std::vector<std::size_t> PointTable::takeChangedRows() {
    std::vector<std::size_t> changed;
    for (std::size_t row = 0; row < m_changed.size(); ++row)
        if (m_changed[row])
            changed.push_back(row);
    m_changed.assign(m_changed.size(), false);
    return changed;
}

} // namespace proveout
