// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace proveout {

/// Which pages of a map are held in a limited number of slots. A page that is no longer needed stays until
/// its slot is needed; the one that has not been needed for longest goes first. It accesses no memory but
/// its own.
class PageResidency {
public:
    static constexpr int kNone = -1;

    /// Forgets everything.
    void reset(std::size_t pages, std::size_t capacity);
    /// The pages that are needed from now on, in the order in which they are loaded.
    void need(std::span<const int> pages);

    struct Load {
        int page = 0;
        int slot = 0;
        int evicted = kNone; ///< the page that was in that slot
    };
    /// The next page to load, which takes its slot at once; nothing if all that are needed are held, or no
    /// slot is left.
    [[nodiscard]] std::optional<Load> nextLoad();

    [[nodiscard]] int slotOf(int page) const { return m_slotOf[static_cast<std::size_t>(page)]; }
    [[nodiscard]] bool holds(int page) const { return slotOf(page) != kNone; }
    [[nodiscard]] std::size_t capacity() const { return m_slots.size(); }

private:
    struct Slot {
        int page = kNone;
        std::uint64_t neededAt = 0;
    };

    std::vector<int> m_slotOf; ///< per page
    std::vector<Slot> m_slots;
    std::vector<int> m_missing; ///< needed and not held, the next one last
    std::uint64_t m_turn = 0;   ///< counts calls of need()
};

} // namespace proveout
