// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

#include "core/base/file_state.h"

namespace proveout {

/// Reports when another program changes a file. Editors save by renaming a new file over the old one;
/// QFileSystemWatcher then forgets the path, so it is added again.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject* parent = nullptr);

    /// Watches `file`; empty: nothing. `known` is its state when it was read, so later changes are reported
    /// too.
    void watch(const QString& file, const FileState& known);
    /// Watches `file` from its current state on; call it after each save by this window.
    void watch(const QString& file);
    /// While it is paused, nothing is reported; what has happened meanwhile is reported afterwards.
    void setPaused(bool paused);

signals:
    void changed();

private:
    void look();

    QString m_file;
    FileState m_known;
    bool m_paused = false;
    QFileSystemWatcher m_watcher;
    QTimer m_settle; ///< a save by renaming is complete when nothing has happened for a moment
};

} // namespace proveout
