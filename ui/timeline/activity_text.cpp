// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/activity_text.h"

#include <algorithm>
#include <array>

#include <QCoreApplication>
#include <QLocale>

namespace proveout {

namespace {

constexpr double kLeastPercent = 0.1; // percentages are shown with one digit

struct LegendRow {
    Activity activity;
    QColor ActivityStrip::Colors::*color;
    const char* sign; ///< the same sign as in the strip
    const char* label;
};
constexpr std::array kRows{
    LegendRow{Activity::cutting, &ActivityStrip::Colors::cutting, "■",
              QT_TRANSLATE_NOOP("Activity", "Cutting")},
    LegendRow{Activity::air, &ActivityStrip::Colors::air, "■", QT_TRANSLATE_NOOP("Activity", "Air cut")},
    LegendRow{Activity::rapid, &ActivityStrip::Colors::rapid, "▒", QT_TRANSLATE_NOOP("Activity", "Rapid")},
    LegendRow{Activity::rapidInStock, &ActivityStrip::Colors::rapidInStock, "■",
              QT_TRANSLATE_NOOP("Activity", "Rapid through stock")},
};

QString text(const char* source) {
    return QCoreApplication::translate("Activity", source);
}

QString number(std::size_t value) {
    return QLocale().toString(static_cast<qulonglong>(value));
}

/// A share that occurs is never shown as 0.
QString percent(double share, bool occurs) {
    const double value = 100 * share;
    const bool little = occurs && value < kLeastPercent;
    const QString digits = QLocale().toString(little ? kLeastPercent : value, 'f', 1);
    return text(QT_TRANSLATE_NOOP("Activity", "%1 %")).arg(little ? QStringLiteral("< ") + digits : digits);
}

QString line(const LegendRow& row, const ActivityStrip::Colors& colors, const QString& what) {
    return QStringLiteral("<span style=\"color:%1\">%2</span> %3")
        .arg((colors.*row.color).name(), QString::fromUtf8(row.sign), what.toHtmlEscaped());
}

} // namespace

QStringList activityLegend(const ActivityLog& log, const ActivityStrip::Stretch& stretch,
                           const ActivityStrip::Colors& colors) {
    const ActivitySums sums = log.sums(stretch.first, stretch.last);
    if (sums.empty())
        return {text(QT_TRANSLATE_NOOP("Activity", "Not simulated yet")).toHtmlEscaped()};
    const std::size_t last = std::min(stretch.last, log.size()); // of the known blocks
    const bool single = last - stretch.first == 1;
    if (!single && !log.times())
        return {};
    QStringList lines;
    if (!single)
        lines << text(QT_TRANSLATE_NOOP("Activity", "Blocks %1 to %2, share of machine time:"))
                     .arg(number(stretch.first + 1), number(last))
                     .toHtmlEscaped();
    for (const LegendRow& row : kRows) {
        if (!sums.has(row.activity))
            continue;
        const QString what = text(row.label);
        lines << line(row, colors,
                      single ? text(QT_TRANSLATE_NOOP("Activity", "Block %1: %2")).arg(number(last), what)
                             : QStringLiteral("%1: %2").arg(what, percent(sums.share(row.activity), true)));
    }
    return lines;
}

QString activitySummary(const ActivityLog& log) {
    const ActivitySums& sums = log.total();
    if (sums.empty() || !log.times())
        return {};
    const auto share = [&](Activity activity) { return percent(sums.share(activity), sums.has(activity)); };
    const bool rapids = sums.has(Activity::rapid) || sums.has(Activity::rapidInStock);
    return text(QT_TRANSLATE_NOOP("Activity",
                                  "Simulated so far: cutting %1, air cut %2, rapid %3 of the time"))
        .arg(share(Activity::cutting), share(Activity::air),
             percent(sums.share(Activity::rapid) + sums.share(Activity::rapidInStock), rapids));
}

} // namespace proveout
