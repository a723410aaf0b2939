// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/row_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

/// The number of rows with a key below `key`.
std::size_t rowsBelow(double key, std::size_t rows) {
    return static_cast<std::size_t>(std::clamp(std::ceil(key) - 1, 0.0, static_cast<double>(rows)));
}

/// The number of rows with a key up to `key`.
std::size_t rowsUpTo(double key, std::size_t rows) {
    return static_cast<std::size_t>(std::clamp(std::floor(key), 0.0, static_cast<double>(rows)));
}

} // namespace

RowExtremes::Rows RowCurve::all() const {
    return rows() == 0 ? RowExtremes::Rows() : RowExtremes::Rows(&*data()->constBegin(), rows());
}

void RowCurve::setValues(std::size_t first, std::span<const double> values) {
    if (values.empty())
        return;
    const std::size_t kept = std::min(values.size(), rows() - first);
    const auto at = data()->begin() + static_cast<std::ptrdiff_t>(first);
    for (std::size_t k = 0; k < kept; ++k)
        (at + static_cast<std::ptrdiff_t>(k))->value = values[k];
    QVector<QCPGraphData> added;
    added.reserve(static_cast<qsizetype>(values.size() - kept));
    for (std::size_t k = kept; k < values.size(); ++k)
        added.append({static_cast<double>(first + k + 1), values[k]});
    data()->add(added, true);
    m_extremes.update(all(), first, first + values.size());
}

void RowCurve::keepRows(std::size_t count) {
    if (count >= rows())
        return;
    data()->removeAfter(static_cast<double>(count)); // the key of the last row that stays
    m_extremes.update(all(), count, count);
}

std::optional<QCPRange> RowCurve::valuesAbove0(const QCPRange& keys) const {
    const Extremes found = m_extremes.of(all(), rowsBelow(keys.lower, rows()), rowsUpTo(keys.upper, rows()));
    if (std::isinf(found.lowestAbove0))
        return std::nullopt;
    return QCPRange(found.lowestAbove0, found.highest);
}

/// Where pixel columns have several rows, the base class would look at each row; a column only needs its
/// lowest and its highest value.
void RowCurve::getOptimizedLineData(QVector<QCPGraphData>* points,
                                    const QCPGraphDataContainer::const_iterator& begin,
                                    const QCPGraphDataContainer::const_iterator& end) const {
    const auto count = end - begin;
    if (count <= 0)
        return;
    const double from = std::floor(keyAxis()->coordToPixel(begin->key));
    const double to = keyAxis()->coordToPixel((end - 1)->key);
    if (static_cast<double>(count) < 2 * (to - from) + 2) {
        QCPGraph::getOptimizedLineData(points, begin, end);
        return;
    }
    auto row = static_cast<std::size_t>(begin - data()->constBegin());
    const std::size_t last = row + static_cast<std::size_t>(count);
    for (double pixel = from; row < last; ++pixel) {
        const double left = keyAxis()->pixelToCoord(pixel);
        const double right = keyAxis()->pixelToCoord(pixel + 1);
        const std::size_t next = std::clamp(rowsBelow(right, rows()), row, last);
        const Extremes column = m_extremes.of(all(), row, next);
        const double quarter = 0.25 * (right - left);
        if (!column.empty()) {
            points->append({left + quarter, column.lowest});
            points->append({right - quarter, column.highest});
        } else if (row < next) {
            points->append({left + quarter, std::numeric_limits<double>::quiet_NaN()});
        }
        row = next;
    }
}

} // namespace proveout
