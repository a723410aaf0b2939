// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>

namespace proveout {

/// Numbers of variables, including both ends.
struct NumberRange {
    int first;
    int last;

    [[nodiscard]] constexpr bool contains(int number) const { return number >= first && number <= last; }
};

[[nodiscard]] constexpr bool anyContains(std::span<const NumberRange> ranges, int number) {
    return std::ranges::any_of(ranges, [number](const NumberRange& range) { return range.contains(number); });
}

} // namespace proveout
