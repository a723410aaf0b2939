// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/chart_view.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>

#include "core/study/svg_chart.h"

namespace proveout {

namespace {
constexpr int kPixelsAUnit = 2; ///< for PNG files
constexpr int kLeastHeight = 160;
} // namespace

ChartView::ChartView(QWidget* parent) : QWidget(parent) {
    setMinimumHeight(kLeastHeight);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ChartView::setChart(const Chart& chart) {
    m_chart = chart;
    setAccessibleName(QString::fromStdString(chart.title));
    setToolTip(QString::fromStdString(chart.title + "\n" + chart.subtitle)); // a low view has no space for it
    layOut();
}

void ChartView::setPlaceholder(const QString& text) {
    m_placeholder = text;
    update();
}

void ChartView::layOut() {
    m_renderer.load(QByteArray::fromStdString(svgChart(m_chart, width(), height())));
    update();
}

void ChartView::resizeEvent(QResizeEvent*) {
    if (!empty())
        layOut();
}

QByteArray ChartView::svg() const {
    return QByteArray::fromStdString(svgChart(m_chart));
}

QByteArray ChartView::png() const {
    QSvgRenderer renderer(svg());
    QImage image(kPixelsAUnit * kChartWidth, kPixelsAUnit * kChartHeight, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    renderer.render(&painter);
    painter.end();
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    image.save(&bytes, "PNG");
    return bytes.data();
}

void ChartView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (empty() || !m_renderer.isValid()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, m_placeholder);
        return;
    }
    painter.fillRect(rect(), Qt::white); // white as on paper, in the dark theme too
    QSizeF size(m_renderer.defaultSize());
    size.scale(QSizeF(rect().size()), Qt::KeepAspectRatio);
    QRectF place(QPointF(0, 0), size);
    place.moveCenter(QRectF(rect()).center());
    m_renderer.render(&painter, place);
}

} // namespace proveout
