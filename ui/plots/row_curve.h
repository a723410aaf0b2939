// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "ui/plots/filled_curve.h"
#include "ui/plots/row_extremes.h"

namespace proveout {

/// A curve with one value per row, whose key is the number of the row, from 1. Its drawing costs as much as
/// the pixels it covers, at any number of rows. Change its values only with these functions.
class RowCurve : public FilledCurve {
public:
    using FilledCurve::FilledCurve;

    [[nodiscard]] std::size_t rows() const { return static_cast<std::size_t>(dataCount()); }
    /// Replaces the values from row `first` <= rows() on, and appends those after the last row.
    void setValues(std::size_t first, std::span<const double> values);
    /// Drops the rows from `count` on.
    void keepRows(std::size_t count);
    /// The range of the values above 0 with keys in a range; empty if there are none.
    [[nodiscard]] std::optional<QCPRange> valuesAbove0(const QCPRange& keys) const;

protected:
    void getOptimizedLineData(QVector<QCPGraphData>* points,
                              const QCPGraphDataContainer::const_iterator& begin,
                              const QCPGraphDataContainer::const_iterator& end) const override;

private:
    [[nodiscard]] RowExtremes::Rows all() const;

    RowExtremes m_extremes;
};

} // namespace proveout
