// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace proveout {

/// Allocates slots in one long buffer for lists that are added and removed. Sizes are rounded up to powers of
/// two, so that a list that changes slightly keeps its slot and freed slots can be reused. Counts elements;
/// it does not access memory.
class SlotAllocator {
public:
    struct Slot {
        std::uint32_t offset = 0;
        std::uint32_t capacity = 0; ///< 0: not allocated
    };

    /// A slot for `count` elements (> 0); extent() may grow.
    [[nodiscard]] Slot allocate(std::uint32_t count);
    void free(Slot slot);
    /// The number of elements that the buffer must hold.
    [[nodiscard]] std::uint32_t extent() const { return m_extent; }
    void clear();
    /// What a list of so many bytes takes at most.
    [[nodiscard]] static std::size_t rounded(std::size_t bytes);

private:
    std::vector<std::vector<std::uint32_t>> m_free; ///< offsets of free slots, by the exponent of their size
    std::uint32_t m_extent = 0;
};

} // namespace proveout
