// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/resource_paths.h"

#include <QCoreApplication>
#include <QDir>

namespace proveout {

namespace {

QDir samplesFolder() {
    const QDir installed(QCoreApplication::applicationDirPath() +
                         QStringLiteral("/../share/proveout/samples"));
    return installed.exists() ? installed : QDir(QStringLiteral(PROVEOUT_SAMPLES_DIR));
}

QString sampleName(const QString& stem) {
    if (stem == QLatin1String("core-insert"))
        return QCoreApplication::translate("Samples", "Core insert");
    if (stem == QLatin1String("mouse-case"))
        return QCoreApplication::translate("Samples", "Mouse case");
    return stem;
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

} // namespace proveout
