// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readout/probe_text.h"

#include <QCoreApplication>

#include "ui/readout/tool_actions.h"

namespace proveout {
namespace {

QString text(const char* source) {
    return QCoreApplication::translate("SurfaceProbe", source);
}

} // namespace

QString toolText(const PlaceAnswer& answer) {
    const QString tool = QStringLiteral("T%1").arg(answer.tool);
    return answer.toolAssumed ? assumedText(tool) : tool;
}

QString positionText(const SurfaceProbe& probe, const QLocale& locale) {
    if (!probe.place())
        return {};
    const Vec3 at = probe.workPosition();
    const auto axis = [&](double value) { return locale.toString(value, 'f', 3); };
    return text(QT_TRANSLATE_NOOP("SurfaceProbe", "X %1  Y %2  Z %3 mm (%4)"))
        .arg(axis(at.x), axis(at.y), axis(at.z), QString::fromStdString(probe.offset().code));
}

QString cutText(const SurfaceProbe& probe) {
    if (!probe.place() || !probe.answer())
        return {};
    const PlaceAnswer& answer = *probe.answer();
    if (answer.kind == PlaceAnswer::Kind::neverCut)
        return text(QT_TRANSLATE_NOOP("SurfaceProbe", "Raw stock"));
    if (answer.kind != PlaceAnswer::Kind::cut)
        return {};
    return text(QT_TRANSLATE_NOOP("SurfaceProbe", "Line %1, %2"))
        .arg(QString::number(answer.line), toolText(answer));
}

} // namespace proveout
