// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/job_permissions.h"

#include <QCryptographicHash>
#include <QSet>
#include <QSettings>
#include <QStringList>

#include "ui/document/file_paths.h"

namespace proveout {

namespace {

const QString kKey = QStringLiteral("jobs/allowedOutside");
constexpr qsizetype kMost = 1000;

/// A job that was moved or copied counts as a different job.
QString digestOf(const std::filesystem::path& job, const std::filesystem::path& file) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArray::fromStdString(absolutePath(job).string()));
    hash.addData(QByteArray(1, '\0')); // a file name cannot contain it
    hash.addData(QByteArray::fromStdString(file.string()));
    return QString::fromLatin1(hash.result().toHex());
}

} // namespace

OutsideRule allowedOutside(const QString& jobFile) {
    const QStringList kept = QSettings().value(kKey).toStringList();
    return [job = toPath(jobFile), known = QSet<QString>(kept.begin(), kept.end())](
               const std::filesystem::path& file) { return known.contains(digestOf(job, file)); };
}

void allowOutside(const QString& jobFile, const std::vector<std::filesystem::path>& files) {
    if (files.empty())
        return;
    QSettings settings;
    QStringList kept = settings.value(kKey).toStringList();
    for (const std::filesystem::path& file : files) {
        const QString digest = digestOf(toPath(jobFile), file);
        kept.removeAll(digest);
        kept.prepend(digest);
    }
    settings.setValue(kKey, kept.mid(0, kMost));
}

} // namespace proveout
