// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <qcustomplot.h>

namespace proveout {

/// A curve whose filling is cut out of one picture, a column of pixels at a time. As a polygon, which crosses
/// itself where many points share a pixel, Qt takes 0.4 s for one jagged curve; so it takes less than its
/// line.
class FilledCurve : public QCPGraph {
public:
    using QCPGraph::QCPGraph;

protected:
    void drawFill(QCPPainter* painter, QVector<QPointF>* lines) const override;

private:
    struct Columns {
        double left = 0;
        double width = 1; ///< of one of them
        std::size_t count = 0;
    };
    /// The highest place of a curve in each column, as y, which grows downwards; NaN where it has none.
    [[nodiscard]] static std::vector<double> highest(const QVector<QPointF>& lines, const Columns& columns);
    [[nodiscard]] std::vector<double> bottoms(const Columns& columns) const;
};

} // namespace proveout
