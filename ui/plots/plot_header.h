// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

namespace proveout {

/// The title of a plot and, where it has several curves, its legend: above the curves, which keep their whole
/// width. The legend is beside the title where there is room, else below.
class PlotHeader {
public:
    /// In a row of its own above the axes; the plot owns what is made. `curves`: how many it will have.
    PlotHeader(QCustomPlot& plot, std::size_t curves);

    void setTitle(const QString& title);
    void style(const QFont& font, const QColor& text);
    /// For a plot of that width, px.
    void fit(int width);

private:
    void placeLegend(int row, int column);

    QCPLayoutGrid* m_grid;
    QCPTextElement* m_title;
    QCPLegend* m_legend; ///< null: one curve, which the title names
};

} // namespace proveout
