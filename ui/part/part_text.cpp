// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/part_text.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace proveout {

namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("PartText", text);
}
QString number(double value, int decimals = kLengthDecimals) {
    return QLocale().toString(value, 'f', decimals);
}
QString number(std::size_t count) {
    return QLocale().toString(static_cast<qulonglong>(count));
}

double deepest(const PartComparison& comparison, IslandKind kind) {
    for (const ComparedIsland& island : comparison.islands) // the deepest first
        if (island.of.kind == kind)
            return island.of.depthMm;
    return 0;
}

} // namespace

QString kindName(IslandKind kind) {
    return kind == IslandKind::gouge ? translated(QT_TRANSLATE_NOOP("PartText", "Gouge"))
                                     : translated(QT_TRANSLATE_NOOP("PartText", "Excess"));
}

QString causeText(const ComparedIsland& island) {
    return island.isUncut ? translated(QT_TRANSLATE_NOOP("PartText", "reached by no tool"))
                          : translated(QT_TRANSLATE_NOOP("PartText", "not determined"));
}

QString islandText(const ComparedIsland& island) {
    const Island& of = island.of;
    QString text = translated(QT_TRANSLATE_NOOP("PartText", "%1, %2 mm deep, %3 mm², %4 mm³, at X%5 Y%6 Z%7"))
                       .arg(kindName(of.kind), number(of.depthMm), number(of.areaMm2, kSizeDecimals),
                            number(of.volumeMm3, kSizeDecimals), number(of.place.x), number(of.place.y),
                            number(of.place.z));
    text += u'\n';
    if (!island.block)
        return text + causeText(island);
    return text + translated(QT_TRANSLATE_NOOP("PartText", "Line %1, T%2"))
                      .arg(QLocale().toString(island.line), QString::number(island.tool));
}

QString resultText(const PartComparison& comparison) {
    const PartTolerance& tolerance = comparison.tolerance;
    const QString allowed = translated(QT_TRANSLATE_NOOP("PartText", "allowed: −%1 to +%2 mm"))
                                .arg(number(tolerance.below), number(tolerance.above));
    QStringList parts;
    if (comparison.gouges > 0)
        parts << translated(QT_TRANSLATE_NOOP("PartText", "Gouges: %1, up to %2 mm deep, %3 mm³"))
                     .arg(number(comparison.gouges), number(deepest(comparison, IslandKind::gouge)),
                          number(comparison.missingMm3, kSizeDecimals));
    if (comparison.excesses > 0)
        parts << translated(QT_TRANSLATE_NOOP("PartText", "Excesses: %1, up to %2 mm high, %3 mm³"))
                     .arg(number(comparison.excesses), number(deepest(comparison, IslandKind::excess)),
                          number(comparison.leftMm3, kSizeDecimals));
    if (parts.isEmpty())
        parts << translated(QT_TRANSLATE_NOOP("PartText", "In tolerance: deviations from %1 to %2 mm"))
                     .arg(number(comparison.lowestMm), number(comparison.highestMm));
    const DeviationLimits& limits = comparison.deviation.limits();
    if (limits.pointsWithoutSide > 0 || limits.unresolvedMm2 > 0)
        parts << translated(QT_TRANSLATE_NOOP("PartText", "not all of it can be judged"));
    return parts.join(QStringLiteral(" · ")) + QStringLiteral(" (%1)").arg(allowed);
}

std::string islandsCsv(const PartComparison& comparison) {
    std::string text = "kind,depthMm,areaMm2,volumeMm3,x,y,z,minX,minY,maxX,maxY,block,line,tool\n";
    for (const ComparedIsland& island : comparison.islands) {
        const Island& of = island.of;
        text += fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},",
                            name(of.kind), of.depthMm, of.areaMm2, of.volumeMm3, of.place.x, of.place.y,
                            of.place.z, of.lo.x, of.lo.y, of.hi.x, of.hi.y);
        text +=
            island.block ? fmt::format("{},{},{}\n", *island.block + 1, island.line, island.tool) : ",,\n";
    }
    return text;
}

} // namespace proveout
