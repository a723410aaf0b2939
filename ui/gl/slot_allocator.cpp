// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/slot_allocator.h"

#include <algorithm>
#include <bit>

namespace proveout {
namespace {
/// Shorter lists all get this capacity.
constexpr std::uint32_t kSmallest = 8;
} // namespace

SlotAllocator::Slot SlotAllocator::allocate(std::uint32_t count) {
    const std::uint32_t capacity = std::bit_ceil(std::max(count, kSmallest));
    const auto power = static_cast<std::size_t>(std::countr_zero(capacity));
    if (m_free.size() <= power)
        m_free.resize(power + 1);
    if (!m_free[power].empty()) {
        const std::uint32_t offset = m_free[power].back();
        m_free[power].pop_back();
        return {offset, capacity};
    }
    const Slot slot{m_extent, capacity};
    m_extent += capacity;
    return slot;
}

std::size_t SlotAllocator::rounded(std::size_t bytes) {
    return std::bit_ceil(std::max<std::size_t>(bytes, kSmallest * sizeof(std::uint32_t)));
}

void SlotAllocator::free(Slot slot) {
    if (slot.capacity > 0)
        m_free[static_cast<std::size_t>(std::countr_zero(slot.capacity))].push_back(slot.offset);
}

void SlotAllocator::clear() {
    m_free.clear();
    m_extent = 0;
}

} // namespace proveout
