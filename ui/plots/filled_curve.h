// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <qcustomplot.h>

namespace proveout {

/// A curve whose fill is cut out of one image, one pixel column at a time. Filled as a polygon, which crosses
/// itself where many points share a pixel, a jagged curve takes Qt 0.4 s; this way the fill is faster than
/// the line.
class FilledCurve : public QCPGraph {
public:
    using QCPGraph::QCPGraph;

protected:
    void drawFill(QCPPainter* painter, QVector<QPointF>* lines) const override;

private:
    struct Columns {
        double left = 0;
        double width = 1; ///< width of one column
        std::size_t count = 0;
    };
    /// The highest position of a curve in each column, as y, which grows downwards; NaN if there is none.
    [[nodiscard]] static std::vector<double> highest(const QVector<QPointF>& lines, const Columns& columns);
    [[nodiscard]] std::vector<double> bottoms(const Columns& columns) const;
};

} // namespace proveout
