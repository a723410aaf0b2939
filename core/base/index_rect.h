// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace proveout {

/// A half-open rectangle of grid indices: columns [i0, i1), rows [j0, j1).
struct IndexRect {
    int i0 = 0;
    int j0 = 0;
    int i1 = 0;
    int j1 = 0;

    [[nodiscard]] bool empty() const { return i0 >= i1 || j0 >= j1; }
    [[nodiscard]] int width() const { return i1 - i0; }
    [[nodiscard]] int height() const { return j1 - j0; }

    friend bool operator==(const IndexRect&, const IndexRect&) = default;
};

[[nodiscard]] inline IndexRect intersection(const IndexRect& a, const IndexRect& b) {
    return {std::max(a.i0, b.i0), std::max(a.j0, b.j0), std::min(a.i1, b.i1), std::min(a.j1, b.j1)};
}

/// The smallest rectangle that holds both; an empty one adds nothing.
[[nodiscard]] inline IndexRect hull(const IndexRect& a, const IndexRect& b) {
    if (a.empty())
        return b;
    if (b.empty())
        return a;
    return {std::min(a.i0, b.i0), std::min(a.j0, b.j0), std::max(a.i1, b.i1), std::max(a.j1, b.j1)};
}

} // namespace proveout
