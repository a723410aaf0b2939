// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

namespace proveout {

/// Tells when one file is changed by somebody else. Editors save by renaming a new file over the old one;
/// QFileSystemWatcher then forgets the path, so it is added again.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject* parent = nullptr);

    /// Watches `file` from its present state on (call it after each own save); empty: nothing.
    void watch(const QString& file);

signals:
    void changed();

private:
    struct State {
        qint64 size = -1; ///< -1: the file is missing
        QDateTime modified;
        friend bool operator==(const State&, const State&) = default;
    };
    [[nodiscard]] State stateOnDisk() const;
    void look();

    QString m_file;
    State m_known;
    QFileSystemWatcher m_watcher;
    QTimer m_settle; ///< a rename-save is over when nothing happened for a moment
};

} // namespace proveout
