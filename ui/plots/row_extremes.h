// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <qcustomplot.h>

namespace proveout {

/// The lowest and the highest of some values; NaN counts as no value.
struct Extremes {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    double lowestAbove0 = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool empty() const { return lowest > highest; }
    void add(double value);
    void add(const Extremes& other);
};

/// The extremes of any stretch of the rows of a curve, in a time that grows with the logarithm of their
/// number: a picture of a million rows then costs as much as its pixels. Less than two bytes per row; the
/// values themselves are with the caller, who passes all of them each time.
class RowExtremes {
public:
    using Rows = std::span<const QCPGraphData>;

    /// The rows from `first` up to `end` have changed, or their number has.
    void update(Rows rows, std::size_t first, std::size_t end);
    /// Of the rows [first, end).
    [[nodiscard]] Extremes of(Rows rows, std::size_t first, std::size_t end) const;

private:
    std::vector<std::vector<Extremes>> m_levels; ///< [k]: one element for 16^(k + 1) rows
};

} // namespace proveout
