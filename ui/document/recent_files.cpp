// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recent_files.h"

#include <mutex>
#include <thread>
#include <utility>

#include <QFileInfo>
#include <QSettings>

namespace proveout {

namespace {

const QString kKey = QStringLiteral("recentFiles");

bool exists(const QString& file) {
    return QFileInfo::exists(file);
}

} // namespace

/// The receiver of the threads' results; the threads may outlive the RecentFiles.
struct RecentFiles::Listener {
    std::mutex mutex;
    RecentFiles* files = nullptr; ///< guarded by mutex; null after its destruction
};

RecentFiles::RecentFiles(QObject* parent) : RecentFiles(&exists, parent) {}

RecentFiles::RecentFiles(Probe probe, QObject* parent)
    : QObject(parent), m_probe(std::move(probe)),
      m_files(QSettings().value(kKey).toStringList().mid(0, kMost)),
      m_listener(std::make_shared<Listener>()) {
    m_listener->files = this;
}

RecentFiles::~RecentFiles() {
    const std::scoped_lock lock(m_listener->mutex);
    m_listener->files = nullptr;
}

void RecentFiles::add(const QString& file) {
    const QString path = QFileInfo(file).absoluteFilePath();
    m_files.removeAll(path);
    m_files.prepend(path);
    m_files = m_files.mid(0, kMost);
    m_there[path] = true;
    store();
}

void RecentFiles::clear() {
    m_files.clear();
    store();
}

void RecentFiles::store() {
    QSettings().setValue(kKey, m_files);
    emit changed();
}

void RecentFiles::look() {
    for (const QString& file : m_files) {
        if (m_asked.contains(file))
            continue;
        m_asked << file;
        // One thread per file, so that a file on an unreachable drive does not delay the others. The threads
        // are detached, because such a check cannot be cancelled and the window must still be able to close.
        std::thread([file, probe = m_probe, listener = m_listener] {
            const bool there = probe(file);
            const std::scoped_lock lock(listener->mutex);
            if (listener->files != nullptr)
                listener->files->m_answers.post(
                    [files = listener->files, file, there] { files->answered(file, there); });
        }).detach();
    }
}

void RecentFiles::answered(const QString& file, bool there) {
    m_asked.removeAll(file);
    const bool known = !isMissing(file);
    m_there[file] = there;
    if (known != there)
        emit changed();
}

bool RecentFiles::isMissing(const QString& file) const {
    const auto found = m_there.find(file);
    return found != m_there.end() && !found->second;
}

} // namespace proveout
