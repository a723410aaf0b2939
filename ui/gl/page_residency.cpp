// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/page_residency.h"

#include <algorithm>

namespace proveout {

void PageResidency::reset(std::size_t pages, std::size_t capacity) {
    m_slotOf.assign(pages, kNone);
    m_slots.assign(capacity, {});
    m_missing.clear();
    m_turn = 0;
}

void PageResidency::need(std::span<const int> pages) {
    ++m_turn;
    m_missing.clear();
    for (const int page : pages)
        if (holds(page))
            m_slots[static_cast<std::size_t>(slotOf(page))].neededAt = m_turn;
        else
            m_missing.push_back(page);
    std::ranges::reverse(m_missing);
}

std::optional<PageResidency::Load> PageResidency::nextLoad() {
    if (m_missing.empty() || m_slots.empty())
        return {};
    const auto slot = std::ranges::min_element(m_slots, {}, &Slot::neededAt); // an empty one has 0
    if (slot->neededAt == m_turn)
        return {};
    const Load load{m_missing.back(), static_cast<int>(slot - m_slots.begin()), slot->page};
    m_missing.pop_back();
    if (load.evicted != kNone)
        m_slotOf[static_cast<std::size_t>(load.evicted)] = kNone;
    m_slotOf[static_cast<std::size_t>(load.page)] = load.slot;
    *slot = {load.page, m_turn};
    return load;
}

} // namespace proveout
