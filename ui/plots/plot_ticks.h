// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

namespace proveout {

/// A number as an axis shows it: large ones shortened, "1.2 M" or "40 k", formatted for the locale.
[[nodiscard]] QString shortNumber(double value, const QLocale& locale);

/// Ticks with such labels. On a logarithmic axis they are at 1, 2 and 5 times every power of ten, or only at
/// 1 if that would be too many.
class PlotTicks : public QCPAxisTicker {
public:
    void setLogarithmic(bool on) { m_logarithmic = on; }
    /// For counts, which have no ticks at fractions.
    void setWhole(bool on) { m_whole = on; }

protected:
    double getTickStep(const QCPRange& range) override;
    int getSubTickCount(double tickStep) override;
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override;
    QVector<double> createTickVector(double tickStep, const QCPRange& range) override;

private:
    bool m_logarithmic = false;
    bool m_whole = false;
};

} // namespace proveout
