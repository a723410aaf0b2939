// SPDX-License-Identifier: GPL-3.0-or-later
// Averages, straight lines and quantiles that summarize the paper's curves and check costs.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

/// The mean of every `window` points (the last window may be shorter), at the mean of their x: the lines of
/// the paper's Fig. 16, with its window of 20 steps.
[[nodiscard]] std::vector<Vec2> windowAverages(std::span<const Vec2> points, std::size_t window);

/// The two ends of the straight line through the points by least squares: the lines of the paper's Fig. 11.
/// Empty for fewer than two different x.
[[nodiscard]] std::vector<Vec2> straightLine(std::span<const Vec2> points);

/// The value below which the share `q` in [0, 1] of the values is, interpolated linearly. NaN if there are no
/// values.
[[nodiscard]] double quantile(std::vector<double> values, double q);

/// Repeated measurements, summarized by two numbers.
struct Measured {
    double median = 0;
    double spread = 0; ///< distance of the quartiles divided by the median
};
[[nodiscard]] Measured measured(const std::vector<double>& values);

} // namespace proveout
