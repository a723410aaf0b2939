// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace proveout {

/// Where an axis begins and ends, and where it is marked. Value type.
struct AxisTicks {
    double lo = 0;
    double hi = 1;
    std::vector<double> places;
    std::vector<std::string> labels; ///< one per mark
};

/// About `count` marks at multiples of 1, 2 or 5 times a power of ten; the ends are marks. `lo` ≤ `hi`.
[[nodiscard]] AxisTicks linearTicks(double lo, double hi, int count);
/// Marks at 1, 2 and 5 times the powers of ten within [lo, hi]; fewer over two decades or more. 0 < `lo` ≤
/// `hi`.
[[nodiscard]] AxisTicks logarithmicTicks(double lo, double hi);

/// A number for display: only the digits that `step` distinguishes, thousands separated by commas.
[[nodiscard]] std::string tickLabel(double value, double step);

} // namespace proveout
