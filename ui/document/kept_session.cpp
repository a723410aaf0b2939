// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/kept_session.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUuid>

#include "core/base/atomic_file.h"
#include "core/base/base_findings.h"
#include "core/base/unfinished_files.h"
#include "core/formats/job_file.h"
#include "core/verification/findings/window_findings.h"
#include "ui/document/file_paths.h"

namespace proveout {

namespace {

constexpr std::uint64_t kLargestRecord = 4'000'000; ///< bytes
const QString kRecord = QStringLiteral("session.json");
const QString kText = QStringLiteral("program.nc");
const QString kJob = QStringLiteral("job.proveout");
const QString kLock = QStringLiteral("lock");

QString in(const QString& folder, const QString& name) {
    return QDir(folder).filePath(name);
}

/// Setup and parameters get a job file of their own in the backup if they are not in one.
Result<void> keepJob(const QString& folder, const JobDocument& document) {
    const QString file = in(folder, kJob);
    if (!document.jobModified()) {
        QFile::remove(file);
        return {};
    }
    Job job = document.job();
    if (job.program.empty())
        job.program = toPath(in(folder, kText)); // a job must name a program
    return writeJob(toPath(file), job);
}

/// Whether the text must be backed up because it is not saved in this form; an empty new program alone is
/// not.
bool isKept(const JobDocument& document) {
    const Document& text = document.text();
    const bool unsaved = text.modified || (text.path.empty() && document.jobModified());
    return unsaved && text.text.size() <= kEditableBytes; // a longer one has only lost its file
}

/// To check later whether a file is still the version that the unsaved changes are based on.
QString digestOf(const DiskCopy& copy, bool needed) {
    return needed ? QString::fromStdString(copy.digest()) : QString();
}

Result<void> keepText(const QString& folder, const JobDocument& document) {
    const QString file = in(folder, kText);
    if (!isKept(document)) {
        QFile::remove(file);
        return {};
    }
    return saveDocument(document.text(), toPath(file));
}

QJsonObject recordOf(const JobDocument& document, const SessionState& state) {
    return {{QStringLiteral("program"), toQString(document.text().path)},
            {QStringLiteral("programDigest"), digestOf(document.textOnDisk(), isKept(document))},
            {QStringLiteral("job"), document.jobFile()},
            {QStringLiteral("jobDigest"), digestOf(document.jobOnDisk(), document.jobModified())},
            {QStringLiteral("time"), QDateTime::currentDateTimeUtc().toString(Qt::ISODate)},
            {QStringLiteral("breakpoints"), QJsonArray::fromStringList(state.breakpoints)},
            {QStringLiteral("layout"), QString::fromLatin1(state.layout.toBase64())}};
}

} // namespace

Result<void> keepSession(const QString& folder, const JobDocument& document, const SessionState& state) {
    if (Result<void> kept = keepText(folder, document); !kept)
        return kept;
    if (Result<void> kept = keepJob(folder, document); !kept)
        return kept;
    const QByteArray record = QJsonDocument(recordOf(document, state)).toJson();
    return writeFile(toPath(in(folder, kRecord)),
                     std::string_view(record.constData(), static_cast<std::size_t>(record.size())));
}

Result<KeptSession> readKeptSession(const QString& folder) {
    const auto bytes = readFile(toPath(in(folder, kRecord)), kLargestRecord);
    const QJsonObject record =
        bytes ? QJsonDocument::fromJson(QByteArray::fromStdString(*bytes)).object() : QJsonObject();
    // A damaged record must not make the text unusable.
    if (record.isEmpty() && !QFile::exists(in(folder, kText)))
        return failure(window_finding::kBackupDamaged, {}, toPath(folder).string());
    const auto text = [&record](const char* key) { return record.value(QLatin1String(key)).toString(); };
    KeptSession kept;
    kept.work.program = toPath(text("program"));
    kept.work.programDigest = text("programDigest").toStdString();
    if (QFile::exists(in(folder, kText)))
        kept.work.keptText = toPath(in(folder, kText));
    kept.work.jobFile = text("job");
    kept.work.jobDigest = text("jobDigest").toStdString();
    kept.work.jobModified = QFile::exists(in(folder, kJob));
    kept.work.keptJob = toPath(kept.work.jobModified ? in(folder, kJob) : kept.work.jobFile);
    const QJsonArray breakpoints = record.value(QLatin1String("breakpoints")).toArray();
    for (const auto each : breakpoints)
        kept.state.breakpoints << each.toString();
    kept.state.layout = QByteArray::fromBase64(text("layout").toLatin1());
    kept.time = QDateTime::fromString(text("time"), Qt::ISODate);
    if (!kept.time.isValid())
        kept.time = QFileInfo(in(folder, kText)).lastModified();
    return kept;
}

SessionFolder::SessionFolder(QString path, std::unique_ptr<QLockFile> lock)
    : m_path(std::move(path)), m_lock(std::move(lock)) {}

Result<SessionFolder> SessionFolder::create(const QString& root) {
    const QString path = in(root, QUuid::createUuid().toString(QUuid::WithoutBraces));
    auto lock = std::make_unique<QLockFile>(in(path, kLock));
    lock->setStaleLockTime(0); // a session may last for days
    if (!QDir().mkpath(path) || !lock->tryLock())
        return failure(base_finding::kFileUnwritable, {std::generic_category().message(errno)},
                       toPath(path).string());
    // The backup must be readable only by the user.
    QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    return SessionFolder(path, std::move(lock));
}

std::vector<SessionFolder> SessionFolder::abandoned(const QString& root) {
    std::vector<SessionFolder> folders;
    for (const QFileInfo& each : QDir(root).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        auto lock = std::make_unique<QLockFile>(in(each.filePath(), kLock));
        lock->setStaleLockTime(0);
        if (lock->tryLock())
            folders.push_back(SessionFolder(each.filePath(), std::move(lock)));
    }
    return folders;
}

void SessionFolder::remove() {
    for (const QString& name : {kRecord, kText, kJob})
        QFile::remove(in(m_path, name));
    removeUnfinished(toPath(m_path)); // otherwise the folder could not be removed
    m_lock->unlock();                 // removes the lock file
    QDir().rmdir(m_path);
}

} // namespace proveout
