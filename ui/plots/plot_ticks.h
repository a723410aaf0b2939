// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

namespace proveout {

/// A number as an axis writes it: large ones short, "1.2 M" and "40 k", in the user's way of writing.
[[nodiscard]] QString shortNumber(double value, const QLocale& locale);

/// Ticks with such labels. On a logarithmic axis they are at 1, 2 and 5 of every power of ten, or at 1 alone
/// where these would be too many.
class PlotTicks : public QCPAxisTicker {
public:
    void setLogarithmic(bool on) { m_logarithmic = on; }
    /// Of what is counted: there is no tick at half of one.
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
