// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readout/cycle_time_text.h"

#include <cmath>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "ui/readout/tool_actions.h"

namespace proveout {

namespace {

constexpr std::size_t kMostTools = 12;  // a tooltip must stay short
constexpr double kLongest = 3600 * 1e6; // s; times over a century are shown as this, however long a dwell is

QString text(const char* source) {
    return QCoreApplication::translate("CycleTime", source);
}

} // namespace

QString clockText(double seconds) {
    if (!(seconds < kLongest))
        return QStringLiteral("> ") + clockText(kLongest - 1);
    const auto whole = static_cast<qlonglong>(std::llround(seconds));
    return QStringLiteral("%1:%2:%3")
        .arg(whole / 3600)
        .arg(whole / 60 % 60, 2, 10, QLatin1Char('0'))
        .arg(whole % 60, 2, 10, QLatin1Char('0'));
}

QString timeTip(const MachineTimes& times, bool assumed, const ToolChoice& choice, const ToolTable& tools) {
    QStringList lines{text(QT_TRANSLATE_NOOP("CycleTime", "Cycle time to this block / of the program")),
                      text(QT_TRANSLATE_NOOP("CycleTime", "Feed %1, rapid %2, dwell %3, tool changes %4"))
                          .arg(clockText(times.parts.feed), clockText(times.parts.rapid),
                               clockText(times.parts.dwell), clockText(times.parts.toolChange))};
    if (times.tools.size() > 1 && times.tools.size() <= kMostTools) {
        for (const MachineTimes::OfTool& tool : times.tools)
            lines << toolText(tool.tool, choice, tools) + QStringLiteral(": ") +
                         clockText(tool.parts.total());
    }
    if (assumed)
        lines << text(QT_TRANSLATE_NOOP(
            "CycleTime", "Default machine values; enter those of your machine in the Setup panel."));
    if (times.motionsWithoutFeed > 0)
        lines << text(QT_TRANSLATE_NOOP("CycleTime", "%1 moves have no feed rate; the maximum is assumed."))
                     .arg(QLocale().toString(static_cast<qulonglong>(times.motionsWithoutFeed)));
    return lines.join(QLatin1Char('\n'));
}

} // namespace proveout
