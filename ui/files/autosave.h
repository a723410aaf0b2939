// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QObject>
#include <QTimer>

#include "ui/document/kept_session.h"
#include "ui/session/session.h"
#include "ui/work/newest_task.h"

namespace proveout {

/// Backs up unsaved work of a session: checks every few seconds for changes and writes them into a folder of
/// its own on its own thread, which takes a twentieth of the time at most: long texts are backed up less
/// often. The user's files are never touched. Thread: UI.
class Autosave final : public QObject {
    Q_OBJECT

public:
    static constexpr int kIntervalMs = 5000; ///< at least

    /// The session must outlive this object. `layout` returns the layout of the window.
    Autosave(Session& session, const QString& root, std::function<QByteArray()> layout);

    /// Writes now, or after the write in progress; `done` is called after a successful write.
    void keepNow(std::function<void()> done);
    /// The session ends normally: its backup is no longer needed.
    void end();

private:
    void look();
    void write();
    /// After a backup that took that long.
    void written(const Result<void>& kept, double seconds, std::vector<std::function<void()>> done);
    void rest(double seconds);
    [[nodiscard]] SessionState state() const;

    Session& m_session;
    std::function<QByteArray()> m_layout;
    std::optional<SessionFolder> m_folder; ///< empty: it cannot be created, or the session has ended
    std::uint64_t m_keptRevision = 0;
    SessionState m_keptState;
    bool m_otherDocument = true; ///< since the last time
    bool m_failed = false;       ///< reported only once
    bool m_writing = false;      ///< nothing is started then: the task's reply would be dropped
    std::vector<std::function<void()>> m_waiting; ///< to be called after the next write
    QTimer m_timer;
    NewestTask m_task; ///< last member: its thread must end before the members that it posts to are destroyed
};

} // namespace proveout
