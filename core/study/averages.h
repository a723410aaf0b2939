// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper's curves and the checks of a cost are summed up with.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

/// The mean of every `window` points (the last window may be shorter), at the mean of their places: the lines
/// of the paper's Fig. 16, with its window of 20 steps.
[[nodiscard]] std::vector<Vec2> windowAverages(std::span<const Vec2> points, std::size_t window);

/// The two ends of the straight line through the points by least squares: the lines of the paper's Fig. 11.
/// Empty for fewer than two places.
[[nodiscard]] std::vector<Vec2> straightLine(std::span<const Vec2> points);

/// The value below which the share `q` in [0, 1] of the values lies, between two values linearly. NaN for
/// none.
[[nodiscard]] double quantile(std::vector<double> values, double q);

/// Repeated measurements in two numbers.
struct Measured {
    double median = 0;
    double spread = 0; ///< distance of the quartiles over the median
};
[[nodiscard]] Measured measured(const std::vector<double>& values);

} // namespace proveout
