// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

namespace proveout {

/// The rows [first, end) of a plot.
struct RowRange {
    std::size_t first = 0;
    std::size_t end = 0;

    [[nodiscard]] bool empty() const { return first >= end; }
    [[nodiscard]] std::size_t size() const { return empty() ? 0 : end - first; }
    /// Extends this to one range that contains both.
    void include(const RowRange& other) {
        if (other.empty())
            return;
        *this = empty() ? other : RowRange{std::min(first, other.first), std::max(end, other.end)};
    }
    /// Drops the rows from `count` on.
    void limit(std::size_t count) { end = std::min(end, count); }
    /// Removes and returns at most `count` rows from the front.
    RowRange takeFront(std::size_t count) {
        const RowRange taken{first, first + std::min(count, size())};
        first = taken.end;
        return taken;
    }
};

} // namespace proveout
