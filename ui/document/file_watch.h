// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

#include "core/base/file_state.h"

namespace proveout {

/// Tells when one file is changed by somebody else. Editors save by renaming a new file over the old one;
/// QFileSystemWatcher then forgets the path, so it is added again.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject* parent = nullptr);

    /// Watches `file`; empty: nothing. `known` is its state as it was read: what has happened to it since is
    /// told too.
    void watch(const QString& file, const FileState& known);
    /// From its present state on; call it after each own save.
    void watch(const QString& file);

signals:
    void changed();

private:
    void look();

    QString m_file;
    FileState m_known;
    QFileSystemWatcher m_watcher;
    QTimer m_settle; ///< a rename-save is over when nothing happened for a moment
};

} // namespace proveout
