// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

namespace proveout {

/// The title of a plot and, if it has several curves, its legend. Both are above the curves, which keep their
/// full width. The legend is next to the title if there is space, otherwise below it.
class PlotHeader {
public:
    /// Placed in a row of its own above the axes; the plot owns the elements. `curves`: their number.
    PlotHeader(QCustomPlot& plot, std::size_t curves);

    void setTitle(const QString& title);
    void style(const QFont& font, const QColor& text);
    /// Arranges title and legend for a plot of that width, px.
    void fit(int width);

private:
    void placeLegend(int row, int column);

    QCPLayoutGrid* m_grid;
    QCPTextElement* m_title;
    QCPLegend* m_legend; ///< null: there is one curve, which the title names
};

} // namespace proveout
