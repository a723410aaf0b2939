// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace proveout {

/// An interval of x; empty when lo > hi.
struct Span {
    double lo;
    double hi;
};

/// The points of one row of a tile: `count` of them at x, x + step, …
struct RowPoints {
    double x;
    double step;
    double y;
    int count;
};

/// A range of the points of a row, half open.
struct Columns {
    int begin = 0;
    int end = 0;

    [[nodiscard]] bool empty() const { return begin >= end; }
};

/// The points that a span covers; computed in double first, as a span may reach farther than any index.
[[nodiscard]] inline Columns columnsUnder(const Span& span, const RowPoints& row) {
    // Rounding must not lose a point on the rim; an extra point costs only its test.
    constexpr double kSlack = 1e-6;
    const double begin = std::ceil((span.lo - row.x) / row.step - kSlack);
    const double end = std::floor((span.hi - row.x) / row.step + kSlack) + 1;
    if (!(begin < end))
        return {};
    return {static_cast<int>(std::clamp(begin, 0.0, static_cast<double>(row.count))),
            static_cast<int>(std::clamp(end, 0.0, static_cast<double>(row.count)))};
}

} // namespace proveout
