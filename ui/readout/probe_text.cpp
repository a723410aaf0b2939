// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readout/probe_text.h"

#include <cmath>
#include <optional>

#include <QCoreApplication>

#include "ui/readout/tool_actions.h"

namespace proveout {
namespace {

QString text(const char* source) {
    return QCoreApplication::translate("SurfaceProbe", source);
}

/// Without the allowance.
std::optional<double> deviationAt(const PickedPlace& place, const PartComparison& comparison) {
    const Deviation& deviation = comparison.deviation;
    const ZMapSnapshot& zmap = place.moment->zmap;
    if (!place.point || !deviation.isOn(zmap))
        return std::nullopt;
    const auto [i, j] = *place.point;
    const auto tile = static_cast<std::size_t>(j / Tile::kSize * zmap.tilesX() + i / Tile::kSize);
    if (zmap.tile(tile) != deviation.stock().tile(tile) || std::isnan(deviation.at(i, j)))
        return std::nullopt;
    return double{deviation.at(i, j)} - comparison.tolerance.allowance;
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

QString deviationText(const SurfaceProbe& probe, const PartComparison* comparison, const QLocale& locale) {
    if (!probe.place() || comparison == nullptr)
        return {};
    const auto value = deviationAt(probe.place()->picked, *comparison);
    if (!value)
        return {};
    const QString number = locale.toString(std::abs(*value), 'f', 3);
    const QString words = (*value < 0 ? QStringLiteral("\u2212%1") : QStringLiteral("+%1")).arg(number);
    if (*value > comparison->tolerance.above)
        return text(QT_TRANSLATE_NOOP("SurfaceProbe", "Deviation %1 mm (excess)")).arg(words);
    if (*value < -comparison->tolerance.below)
        return text(QT_TRANSLATE_NOOP("SurfaceProbe", "Deviation %1 mm (gouge)")).arg(words);
    return text(QT_TRANSLATE_NOOP("SurfaceProbe", "Deviation %1 mm")).arg(words);
}

} // namespace proveout
