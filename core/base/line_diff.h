// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace proveout {

/// A stretch in which two texts differ: the lines [beforeFirst, beforeLast) of one are replaced by the lines
/// [afterFirst, afterLast) of the other. 0-based; either range may be empty.
struct LineChange {
    std::size_t beforeFirst = 0;
    std::size_t beforeLast = 0;
    std::size_t afterFirst = 0;
    std::size_t afterLast = 0;

    friend bool operator==(const LineChange&, const LineChange&) = default;
};

/// The fewest changes are found up to this number of inserted and removed lines; time and memory grow with
/// its square.
inline constexpr std::size_t kMostLineEdits = 1500;

/// Where two texts differ, ascending and apart from each other: as few inserted and removed lines as possible
/// (Myers, An O(ND) Difference Algorithm, 1986). If that needs more than `mostEdits` lines, everything
/// between the equal lines at the beginning and the equal lines at the end is one change. Any thread.
[[nodiscard]] std::vector<LineChange> compareLines(const std::vector<std::string_view>& before,
                                                   const std::vector<std::string_view>& after,
                                                   std::size_t mostEdits = kMostLineEdits);

} // namespace proveout
