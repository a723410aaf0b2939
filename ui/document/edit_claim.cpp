// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/edit_claim.h"

#include <utility>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QLockFile>
#include <QStandardPaths>

#include "core/formats/job_paths.h"
#include "ui/document/file_paths.h"

namespace proveout {

namespace {

constexpr int kBetweenLooksMs = 2000;

/// The same name for every path that leads to the file. It is a digest, because a path may be longer than a
/// file name may be.
QString lockName(const QString& file) {
    const QByteArray path = QByteArray::fromStdString(absolutePath(toPath(file)).string());
    return QString::fromLatin1(QCryptographicHash::hash(path, QCryptographicHash::Sha1).toHex()) +
           QStringLiteral(".lock");
}

} // namespace

QString EditClaim::defaultRoot() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
        .filePath(QStringLiteral("edited"));
}

EditClaim::EditClaim(QString root, QObject* parent) : QObject(parent), m_root(std::move(root)) {
    m_timer.setInterval(kBetweenLooksMs);
    connect(&m_timer, &QTimer::timeout, this, &EditClaim::look);
}

EditClaim::~EditClaim() = default; // destroying the lock removes its file

void EditClaim::follow(const QString& file, bool modified) {
    if (file == m_file && modified == m_modified)
        return;
    if (file != m_file) {
        m_lock.reset();
        m_file = file;
    }
    m_modified = modified;
    if (m_file.isEmpty())
        m_timer.stop();
    else
        m_timer.start();
    look();
}

void EditClaim::look() {
    std::optional<EditHolder> other = m_file.isEmpty() ? std::nullopt : findOther();
    if (std::exchange(m_other, std::move(other)) != m_other)
        emit otherChanged();
}

/// Claims the file if this window has unsaved changes, and releases it otherwise.
std::optional<EditHolder> EditClaim::findOther() {
    if (!m_lock) {
        QDir().mkpath(m_root);
        m_lock = std::make_unique<QLockFile>(QDir(m_root).filePath(lockName(m_file)));
        m_lock->setStaleLockTime(0); // a window may be open for days
    }
    if (m_lock->isLocked()) {
        if (!m_modified)
            m_lock->unlock();
        return std::nullopt;
    }
    if (!m_modified && !QFile::exists(m_lock->fileName()))
        return std::nullopt;
    if (m_lock->tryLock()) { // a lock of a process that has ended is replaced
        if (!m_modified)
            m_lock->unlock();
        return std::nullopt;
    }
    EditHolder other;
    QString application;
    if (m_lock->error() != QLockFile::LockFailedError ||
        !m_lock->getLockInfo(&other.process, &other.computer, &application))
        return std::nullopt; // the folder is not writable, or the claim has just been released
    return other;
}

} // namespace proveout
