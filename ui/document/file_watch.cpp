// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/file_watch.h"

#include <QFileInfo>

#include "ui/document/file_paths.h"

namespace proveout {

namespace {
constexpr int kSettleMs = 150;
}

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettleMs);
    connect(&m_settle, &QTimer::timeout, this, &FileWatch::look);
    const auto settle = [this] { m_settle.start(); };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, settle);
    // The folder's signal reports when a removed file reappears.
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, settle);
}

void FileWatch::watch(const QString& file) {
    watch(file, stateOf(toPath(file)));
}

void FileWatch::watch(const QString& file, const FileState& known) {
    m_settle.stop();
    if (!m_watcher.files().isEmpty())
        m_watcher.removePaths(m_watcher.files());
    if (!m_watcher.directories().isEmpty())
        m_watcher.removePaths(m_watcher.directories());
    m_file = file;
    if (file.isEmpty())
        return;
    m_known = known;
    m_watcher.addPath(file);
    m_watcher.addPath(QFileInfo(file).absolutePath());
    m_settle.start(); // changes before this point are compared once the watcher is set up completely
}

void FileWatch::setPaused(bool paused) {
    m_paused = paused;
    if (!paused)
        m_settle.start();
}

void FileWatch::look() {
    if (m_file.isEmpty() || m_paused)
        return;
    if (!m_watcher.files().contains(m_file))
        m_watcher.addPath(m_file);
    const FileState state = stateOf(toPath(m_file));
    if (state == m_known)
        return;
    m_known = state;
    emit changed();
}

} // namespace proveout
