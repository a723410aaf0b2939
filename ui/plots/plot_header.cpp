// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_header.h"

namespace proveout {
namespace {

constexpr double kAsLittleAsPossible = 1e-3; // share of the stretchable space
constexpr int kMargin = 4;                   // px

int widthOf(const QCPLayoutElement& element) {
    return element.minimumOuterSizeHint().width();
}

} // namespace

PlotHeader::PlotHeader(QCustomPlot& plot, std::size_t curves)
    : m_grid(new QCPLayoutGrid), m_title(new QCPTextElement(&plot)), m_legend(plot.legend) {
    plot.plotLayout()->insertRow(0);
    plot.plotLayout()->addElement(0, 0, m_grid);
    plot.plotLayout()->setRowStretchFactor(0, kAsLittleAsPossible);
    plot.plotLayout()->setRowSpacing(0);
    m_grid->setRowSpacing(0);
    m_grid->setMargins({kMargin, 2, kMargin, 0});
    m_title->setTextFlags(Qt::AlignLeft | Qt::AlignTop);
    m_title->setMargins({2, 0, 2, 0});
    m_grid->addElement(0, 0, m_title);
    if (curves < 2) {
        plot.axisRect()->insetLayout()->remove(m_legend);
        m_legend = nullptr;
        return;
    }
    m_legend->setVisible(true);
    m_legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    m_legend->setMargins({2, 0, 2, 0});
    m_legend->setBorderPen(Qt::NoPen);
    m_legend->setBrush(Qt::NoBrush);
    plot.axisRect()->insetLayout()->take(m_legend);
    placeLegend(0, 1);
}

void PlotHeader::setTitle(const QString& title) {
    m_title->setText(title);
}

void PlotHeader::style(const QFont& font, const QColor& text) {
    QFont bold = font;
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextColor(text);
    if (m_legend == nullptr)
        return;
    m_legend->setFont(font);
    m_legend->setTextColor(text);
    const QFontMetrics metrics(font);
    m_legend->setIconSize(metrics.height(), metrics.height() / 2);
    // An item is as high as the text is for the layout, which is less than a text with descenders takes.
    for (int i = 0; i < m_legend->itemCount(); ++i)
        m_legend->item(i)->setMargins({0, 0, 0, metrics.descent()});
}

void PlotHeader::fit(int width) {
    if (m_legend == nullptr)
        return;
    const int needed = widthOf(*m_title) + widthOf(*m_legend);
    const int row = needed + 4 * kMargin > width ? 1 : 0;
    const int column = 1 - row;
    if (m_grid->hasElement(row, column) && m_grid->element(row, column) == m_legend)
        return;
    m_grid->take(m_legend);
    m_grid->simplify();
    placeLegend(row, column);
}

void PlotHeader::placeLegend(int row, int column) {
    m_grid->addElement(row, column, m_legend);
    m_grid->setColumnStretchFactor(0, 1); // the title gets the remaining width
    if (column > 0)
        m_grid->setColumnStretchFactor(column, kAsLittleAsPossible);
}

} // namespace proveout
