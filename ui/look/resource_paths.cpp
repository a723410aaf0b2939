// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/resource_paths.h"

#include <algorithm>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStringList>

namespace proveout {

namespace {

/// The folder below the install prefix, or else in the source tree.
QDir productFolder(const QString& installed, const QString& inSources) {
    const QDir folder(QCoreApplication::applicationDirPath() + QStringLiteral("/../share/proveout/") +
                      installed);
    return folder.exists() ? folder : QDir(inSources);
}

QDir samplesFolder() {
    return productFolder(QStringLiteral("samples"), QStringLiteral(PROVEOUT_SAMPLES_DIR));
}

QString sampleName(const QString& stem) {
    if (stem == QLatin1String("core-insert"))
        return QCoreApplication::translate("Samples", "Core insert");
    if (stem == QLatin1String("mouse-case"))
        return QCoreApplication::translate("Samples", "Mouse case");
    return stem;
}

/// The text after "# " in the first line of a page.
QString headingOf(const QString& file) {
    QFile page(file);
    if (!page.open(QIODevice::ReadOnly))
        return QFileInfo(file).completeBaseName();
    return QString::fromUtf8(page.readLine()).remove(QLatin1Char('#')).trimmed();
}

} // namespace

std::vector<SampleJob> sampleJobs() {
    std::vector<SampleJob> jobs;
    const QDir folder = samplesFolder();
    for (const QFileInfo& file :
         folder.entryInfoList({QStringLiteral("*.proveout")}, QDir::Files, QDir::Name))
        jobs.push_back({sampleName(file.completeBaseName()), file.absoluteFilePath()});
    return jobs;
}

bool isSample(const QString& file) {
    return !file.isEmpty() &&
           QFileInfo(file).dir().canonicalPath() == QDir(samplesFolder().path()).canonicalPath();
}

std::vector<GuidePage> guidePages() {
    const QDir folder = productFolder(QStringLiteral("guide"), QStringLiteral(PROVEOUT_GUIDE_DIR));
    const QStringList first{"index",       "reads",   "program", "setup",  "problems", "timeline", "view",
                            "breakpoints", "control", "plots",   "tuning", "study",    "files"};
    QStringList ids;
    for (const QFileInfo& file : folder.entryInfoList({QStringLiteral("*.md")}, QDir::Files, QDir::Name))
        ids << file.completeBaseName();
    std::stable_sort(ids.begin(), ids.end(), [&first](const QString& one, const QString& other) {
        const auto place = [&first](const QString& id) {
            return first.contains(id) ? first.indexOf(id) : first.size();
        };
        return place(one) < place(other);
    });
    std::vector<GuidePage> pages;
    for (const QString& id : ids) {
        const QString file = folder.filePath(id + QStringLiteral(".md"));
        pages.push_back({id, headingOf(file), file});
    }
    return pages;
}

} // namespace proveout
