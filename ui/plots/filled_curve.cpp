// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/filled_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

void paintWith(QImage& image, const QBrush& brush, const QRect& place) {
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.translate(-place.topLeft());
    painter.fillRect(place, brush);
}

/// Converts y positions to rows of an image whose first row is at `top`; NaN becomes one past the last row.
std::vector<int> rowsOf(const std::vector<double>& places, int top, const QImage& image) {
    std::vector<int> rows(places.size(), image.height());
    for (std::size_t column = 0; column < places.size(); ++column) {
        const double row = (places[column] - top) * image.devicePixelRatio();
        if (row < image.height()) // false if the position is NaN
            rows[column] = static_cast<int>(std::lround(std::max(0.0, row)));
    }
    return rows;
}

/// Clears everything except the rows [first, last) of each column.
void cutOut(QImage& image, const std::vector<int>& first, const std::vector<int>& last) {
    for (int y = 0; y < image.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (std::size_t column = 0; column < first.size(); ++column) {
            if (y < first[column] || y >= last[column])
                row[column] = 0;
        }
    }
}

} // namespace

void FilledCurve::drawFill(QCPPainter* painter, QVector<QPointF>* lines) const {
    if (brush().style() == Qt::NoBrush)
        return;
    if (painter->modes().testFlag(QCPPainter::pmVectorized)) {
        QCPGraph::drawFill(painter, lines);
        return;
    }
    const QRect rect = keyAxis()->axisRect()->rect();
    const double scale = painter->deviceTransform().m11();
    QImage filling(QSize(static_cast<int>(std::ceil(rect.width() * scale)),
                         static_cast<int>(std::ceil(rect.height() * scale))),
                   QImage::Format_ARGB32_Premultiplied);
    if (filling.isNull())
        return;
    filling.setDevicePixelRatio(scale);
    paintWith(filling, brush(), rect);
    const Columns columns{static_cast<double>(rect.left()), 1 / scale,
                          static_cast<std::size_t>(filling.width())};
    cutOut(filling, rowsOf(highest(*lines, columns), rect.top(), filling),
           rowsOf(bottoms(columns), rect.top(), filling));
    applyFillAntialiasingHint(painter);
    painter->drawImage(rect.topLeft(), filling);
}

std::vector<double> FilledCurve::bottoms(const Columns& columns) const {
    // All curves of our plots have this class.
    if (const auto* other = dynamic_cast<const FilledCurve*>(channelFillGraph())) {
        QVector<QPointF> lines;
        other->getLines(&lines, QCPDataRange(0, other->dataCount()));
        return highest(lines, columns);
    }
    // A logarithmic axis has no 0.
    const bool even = valueAxis()->scaleType() == QCPAxis::stLinear;
    return std::vector<double>(columns.count,
                               valueAxis()->coordToPixel(even ? 0 : valueAxis()->range().lower));
}

std::vector<double> FilledCurve::highest(const QVector<QPointF>& lines, const Columns& columns) {
    std::vector<double> tops(columns.count, std::numeric_limits<double>::quiet_NaN());
    const auto last = static_cast<double>(columns.count) - 1;
    const auto raise = [&](double column, double y) {
        double& top = tops[static_cast<std::size_t>(column)];
        top = top <= y ? top : y; // y if top is still NaN
    };
    const auto place = [&](double x) { return (x - columns.left) / columns.width; };
    const QPointF* before = nullptr;
    for (const QPointF& point : lines) {
        const bool known = std::isfinite(point.x()) && std::isfinite(point.y());
        if (known && place(point.x()) >= 0 && place(point.x()) <= last)
            raise(std::floor(place(point.x())), point.y()); // a peak narrower than a column
        if (known && before != nullptr && point.x() > before->x()) {
            const double slope = (point.y() - before->y()) / (point.x() - before->x());
            const double from = std::max(0.0, std::ceil(place(before->x()) - 0.5));
            const double to = std::min(last, std::floor(place(point.x()) - 0.5));
            for (double column = from; column <= to; ++column) {
                const double middle = columns.left + (column + 0.5) * columns.width;
                raise(column, before->y() + slope * (middle - before->x()));
            }
        }
        before = known ? &point : nullptr;
    }
    return tops;
}

} // namespace proveout
