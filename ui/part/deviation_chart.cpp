// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/deviation_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>

namespace proveout {

namespace {

constexpr int kBins = DeviationHistogram::kBins;
constexpr QSize kSmallest{180, 90};
constexpr QSize kUsual{240, 150};
constexpr double kMargin = 8;

/// Vermilion and blue of Okabe and Ito, as in the view; the middle by the palette.
const QColor kMissing(213, 94, 0);
const QColor kLeft(0, 114, 178);

} // namespace

DeviationChart::DeviationChart(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("deviation-chart"));
}

void DeviationChart::setComparison(std::shared_ptr<const PartComparison> comparison) {
    m_comparison = std::move(comparison);
    update();
}

QSize DeviationChart::sizeHint() const {
    return kUsual;
}
QSize DeviationChart::minimumSizeHint() const {
    return kSmallest;
}

QRectF DeviationChart::plotRect() const {
    const double text = fontMetrics().height();
    return QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -(text + kMargin / 2));
}

void DeviationChart::paintEvent(QPaintEvent*) {
    if (!m_comparison)
        return;
    QPainter painter(this);
    const QRectF plot = plotRect();
    const DeviationHistogram& histogram = m_comparison->histogram;
    const PartTolerance& tolerance = m_comparison->tolerance;
    const double width = plot.width() / kBins;
    const auto xOf = [&](double mm) { return plot.left() + (mm / histogram.width + kBins / 2.0) * width; };
    // Most points are in tolerance: on a logarithmic scale the others can be seen as well.
    const auto highest = static_cast<double>(*std::ranges::max_element(histogram.points));
    const auto share = [&](std::size_t points) {
        return points == 0 ? 0 : std::log1p(static_cast<double>(points)) / std::log1p(highest);
    };
    QColor within = palette().color(QPalette::Text);
    within.setAlphaF(0.45F);
    for (int bin = 0; bin < kBins; ++bin) {
        const double middle = histogram.middleOf(bin);
        const QColor colour = middle < -tolerance.below  ? kMissing
                              : middle > tolerance.above ? kLeft
                                                         : within;
        const double height = share(histogram.points[static_cast<std::size_t>(bin)]) * plot.height();
        painter.fillRect(
            QRectF(plot.left() + bin * width + 0.5, plot.bottom() - height, std::max(width - 1, 1.0), height),
            colour);
    }
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DashLine));
    const double below = xOf(-tolerance.below);
    const double above = xOf(tolerance.above);
    for (const double x : {below, above})
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    painter.setPen(palette().color(QPalette::Text));
    const QRectF line(plot.left(), plot.bottom() + 2, plot.width(), fontMetrics().height());
    const QString low = QStringLiteral("−%1").arg(locale().toString(tolerance.below));
    const QString high = QStringLiteral("+%1").arg(locale().toString(tolerance.above));
    painter.drawText(QRectF(line.left(), line.top(), below - line.left() + fontMetrics().averageCharWidth(),
                            line.height()),
                     Qt::AlignRight | Qt::AlignVCenter, low);
    painter.drawText(QRectF(above - fontMetrics().averageCharWidth(), line.top(),
                            line.right() - above + fontMetrics().averageCharWidth(), line.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, high + QStringLiteral(" mm"));
    painter.drawText(line, Qt::AlignHCenter | Qt::AlignVCenter, QStringLiteral("0"));
}

QString DeviationChart::binText(int bin) const {
    const DeviationHistogram& histogram = m_comparison->histogram;
    const double middle = histogram.middleOf(bin);
    const QString points =
        tr("%n point(s)", nullptr, static_cast<int>(histogram.points[static_cast<std::size_t>(bin)]));
    const auto number = [this](double mm) { return locale().toString(mm, 'f', 3); };
    if (bin == 0)
        return tr("below %1 mm: %2").arg(number(middle + histogram.width / 2), points);
    if (bin == kBins - 1)
        return tr("above %1 mm: %2").arg(number(middle - histogram.width / 2), points);
    return tr("%1 to %2 mm: %3")
        .arg(number(middle - histogram.width / 2), number(middle + histogram.width / 2), points);
}

bool DeviationChart::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || !m_comparison)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QRectF plot = plotRect();
    const int bin = static_cast<int>(std::floor((help->pos().x() - plot.left()) / plot.width() * kBins));
    if (bin >= 0 && bin < kBins)
        QToolTip::showText(help->globalPos(), binText(bin), this);
    return true;
}

} // namespace proveout
