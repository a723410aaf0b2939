// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_grid.h"

#include <algorithm>

#include <QScrollBar>

namespace proveout {

PlotGrid::PlotGrid(QWidget* parent) : QScrollArea(parent), m_inner(new QWidget) {
    setWidget(m_inner);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus); // the plots take the focus
}

void PlotGrid::add(PlotView* plot) {
    plot->setParent(m_inner);
    m_plots.push_back(plot);
    arrange();
}

void PlotGrid::setShown(PlotView& plot, bool shown) {
    plot.setVisible(shown);
    arrange();
}

void PlotGrid::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    arrange();
}

void PlotGrid::arrange() {
    std::vector<PlotView*> shown;
    std::ranges::copy_if(m_plots, std::back_inserter(shown),
                         [](const PlotView* plot) { return !plot->isHidden(); });
    const auto count = static_cast<int>(shown.size());
    if (count == 0)
        return m_inner->resize(viewport()->size());
    const QSize area = viewport()->size();
    const int most = std::clamp(area.width() / kLeastWidth, 1, count);
    const int rows = (count + most - 1) / most;
    const int columns = (count + rows - 1) / rows; // makes all rows about equally long
    const int height = std::max(kLeastHeight, area.height() / rows);
    const bool scrolls = rows * height > area.height();
    m_inner->resize(area.width(), scrolls ? rows * height : area.height());
    for (int k = 0; k < count; ++k) {
        const int row = k / columns;
        const int inRow = std::min(columns, count - row * columns); // the last row may have fewer
        const int left = area.width() * (k % columns) / inRow;
        const int right = area.width() * (k % columns + 1) / inRow;
        shown[static_cast<std::size_t>(k)]->setGeometry(left, row * height, right - left, height);
        shown[static_cast<std::size_t>(k)]->setScrollBar(scrolls ? verticalScrollBar() : nullptr);
    }
}

} // namespace proveout
