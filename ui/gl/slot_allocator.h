// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace proveout {

/// Places in one long buffer for many lists that come and go. Sizes are rounded up to powers of two, so that
/// a list that changes a little keeps its place and freed places fit again. Counts elements, knows no memory.
class SlotAllocator {
public:
    struct Slot {
        std::uint32_t offset = 0;
        std::uint32_t capacity = 0; ///< 0: no place
    };

    /// A place for `count` elements (> 0); extent() may grow.
    [[nodiscard]] Slot allocate(std::uint32_t count);
    void free(Slot slot);
    /// Elements that the buffer must hold.
    [[nodiscard]] std::uint32_t extent() const { return m_extent; }
    void clear();

private:
    std::vector<std::vector<std::uint32_t>> m_free; ///< offsets of free places, by the power of two
    std::uint32_t m_extent = 0;
};

} // namespace proveout
