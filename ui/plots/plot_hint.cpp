// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_hint.h"

#include <QCoreApplication>
#include <QKeySequence>

#include "ui/session/measure_key.h"

namespace proveout {

PlotHint::PlotHint(QCustomPlot& plot) : m_text(new QCPItemText(&plot)) {
    m_text->position->setType(QCPItemPosition::ptAxisRectRatio);
    m_text->setPadding(QMargins(6, 3, 6, 3));
}

void PlotHint::retranslate() {
    update();
}

void PlotHint::style(const QFont& font, const QColor& text, const QColor& ground) {
    m_text->setFont(font);
    m_text->setColor(text);
    m_text->setBrush(ground);
}

void PlotHint::setEmpty(bool empty) {
    m_empty = empty;
    update();
}

void PlotHint::setIncomplete(bool incomplete) {
    m_incomplete = incomplete;
    update();
}

void PlotHint::update() {
    constexpr double kMiddle = 0.5;
    constexpr double kLow = 0.6; // most curves start at 0, but few stay there
    m_text->setVisible(m_empty || m_incomplete);
    m_text->position->setCoords(kMiddle, m_empty ? kMiddle : kLow);
    const QString key = QKeySequence(QLatin1String(kMeasureKey)).toString(QKeySequence::NativeText);
    m_text->setText(m_empty ? QCoreApplication::translate("PlotView", "Play to measure")
                            : QCoreApplication::translate("PlotView", "Not measured.") + u'\n' +
                                  QCoreApplication::translate("PlotView", "Play, or press %1.").arg(key));
}

} // namespace proveout
