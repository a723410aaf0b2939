// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSvgRenderer>
#include <QWidget>

#include "core/study/chart.h"

namespace proveout {

/// Shows a chart laid out for the view's own size; exported charts have the size of the study's files.
class ChartView final : public QWidget {
    Q_OBJECT

public:
    explicit ChartView(QWidget* parent = nullptr);
    void setChart(const Chart& chart);
    /// The text that is shown while there is no chart.
    void setPlaceholder(const QString& text);
    [[nodiscard]] const Chart& chart() const { return m_chart; }
    [[nodiscard]] bool empty() const { return m_chart.curves.empty(); }
    [[nodiscard]] QByteArray svg() const;
    [[nodiscard]] QByteArray png() const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();

    Chart m_chart;
    QString m_placeholder;
    QSvgRenderer m_renderer;
};

} // namespace proveout
