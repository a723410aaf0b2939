// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_ticks.h"

#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

constexpr double kThousand = 1e3;
constexpr double kMillion = 1e6;
constexpr double kWrittenOut = 1e4; ///< smaller numbers are not shortened
constexpr int kDigits = 4;          ///< of a short number
constexpr int kExactDigits = 12;    ///< more than any tick needs
const QString kNarrowSpace(QChar(0x202F));

QVector<double> logarithmicTicks(const QCPRange& range, const QVector<double>& ofPower) {
    QVector<double> ticks;
    for (double power = std::pow(10, std::floor(std::log10(range.lower))); power <= range.upper; power *= 10)
        for (const double digit : ofPower)
            if (range.contains(digit * power))
                ticks << digit * power;
    return ticks;
}

} // namespace

QString shortNumber(double value, const QLocale& locale) {
    const double size = std::abs(value);
    if (size >= kMillion)
        return locale.toString(value / kMillion, 'g', kDigits) + kNarrowSpace + u'M';
    if (size >= kWrittenOut)
        return locale.toString(value / kThousand, 'g', kDigits) + kNarrowSpace + u'k';
    return locale.toString(value, 'g', kExactDigits);
}

double PlotTicks::getTickStep(const QCPRange& range) {
    const double step = QCPAxisTicker::getTickStep(range);
    return m_whole ? std::max(1.0, std::ceil(step)) : step;
}

int PlotTicks::getSubTickCount(double tickStep) {
    return m_logarithmic || m_whole ? 0 : QCPAxisTicker::getSubTickCount(tickStep);
}

QString PlotTicks::getTickLabel(double tick, const QLocale& locale, QChar, int) {
    return shortNumber(tick, locale);
}

QVector<double> PlotTicks::createTickVector(double tickStep, const QCPRange& range) {
    constexpr qsizetype kFewest = 2;
    if (m_logarithmic && range.lower > 0) {
        QVector<double> all = logarithmicTicks(range, {1, 2, 5});
        if (all.size() >= kFewest && all.size() <= tickCount() + 1)
            return all;
        if (QVector<double> powers = logarithmicTicks(range, {1}); powers.size() >= kFewest)
            return powers;
        if (all.size() >= kFewest)
            return {all.front(), all.back()};
    }
    return QCPAxisTicker::createTickVector(tickStep, range);
}

} // namespace proveout
