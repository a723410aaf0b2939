// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readout/export_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace proveout {

namespace {

constexpr int kErrorDecimals = 6;

QString translated(const char* text) {
    return QCoreApplication::translate("Export", text);
}

/// Shortens a long name in the middle, so that the text after it stays visible.
QString shortName(const QString& file) {
    constexpr int kLongest = 24;
    QString name = QFileInfo(file).fileName();
    if (name.size() <= kLongest)
        return name;
    return name.first(kLongest / 2) + QChar(0x2026) + name.last(kLongest / 2 - 1);
}

/// The block up to which the program had run; empty at its end.
QString momentOf(const ExportSummary& summary, const QLocale& locale) {
    if (summary.block >= summary.blocks)
        return {};
    return u' ' + translated(QT_TRANSLATE_NOOP("Export", "(block %1 of %2)"))
                      .arg(locale.toString(static_cast<qulonglong>(summary.block)),
                           locale.toString(static_cast<qulonglong>(summary.blocks)));
}

/// The error of the file, and whether it is guaranteed to be within the allowance.
QString errorText(const ExportSummary& summary, const QLocale& locale) {
    const QString error = locale.toString(summary.largestErrorMm, 'f', kErrorDecimals);
    const QString allowance = locale.toString(summary.allowanceMm);
    if (summary.allowanceMm == 0)
        return translated(QT_TRANSLATE_NOOP("Export", "full resolution, largest error %1 mm")).arg(error);
    if (!summary.certified)
        return translated(QT_TRANSLATE_NOOP("Export", "largest measured error %1 mm, not guaranteed"))
            .arg(error);
    if (summary.largestErrorMm > summary.allowanceMm)
        return translated(QT_TRANSLATE_NOOP("Export", "largest error %1 mm exceeds the allowance of %2 mm"))
            .arg(error, allowance);
    if (summary.level == ErrorLevel::surface && summary.hasWalls)
        return translated(
                   QT_TRANSLATE_NOOP("Export",
                                     "largest error %1 mm, certified within %2 mm everywhere but at walls"))
            .arg(error, allowance);
    if (summary.level == ErrorLevel::surface)
        return translated(
                   QT_TRANSLATE_NOOP("Export", "largest error %1 mm, certified within %2 mm everywhere"))
            .arg(error, allowance);
    return translated(QT_TRANSLATE_NOOP("Export",
                                        "largest error %1 mm, certified within %2 mm at every z-map point"))
        .arg(error, allowance);
}

} // namespace

QString exportText(const ExportSummary& summary, const QLocale& locale) {
    const QString name = shortName(summary.file) + momentOf(summary, locale);
    if (summary.stock)
        return translated(QT_TRANSLATE_NOOP("Export", "Saved %1: the stock for the next setup")).arg(name);
    return translated(QT_TRANSLATE_NOOP("Export", "Exported %1: %2")).arg(name, errorText(summary, locale));
}

QString exportDetails(const ExportSummary& summary, const QLocale& locale) {
    const QString size =
        locale.formattedDataSize(static_cast<qint64>(summary.bytes), 1, QLocale::DataSizeSIFormat);
    if (summary.stock)
        return QStringLiteral("%1: %2").arg(QDir::toNativeSeparators(summary.file), size);
    return translated(QT_TRANSLATE_NOOP("Export", "%1: %2 triangles, %3"))
        .arg(QDir::toNativeSeparators(summary.file),
             locale.toString(static_cast<qulonglong>(summary.triangles)), size);
}

} // namespace proveout
