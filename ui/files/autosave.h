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

/// Keeps what a session has not saved: looks every few seconds whether there is something new, and writes it
/// into a folder of its own, on a thread of its own. The files of the user are never touched. Thread: UI.
class Autosave final : public QObject {
    Q_OBJECT

public:
    static constexpr int kIntervalMs = 5000;

    /// The session outlives this object. `layout` is asked for the layout of the window.
    Autosave(Session& session, const QString& root, std::function<QByteArray()> layout);

    /// Writes now; `done` is called when it is written, not where that failed.
    void keepNow(std::function<void()> done);
    /// The session ends by itself: nothing has to be kept of it any more.
    void end();

private:
    void look();
    [[nodiscard]] SessionState state() const;

    Session& m_session;
    std::function<QByteArray()> m_layout;
    std::optional<SessionFolder> m_folder; ///< nothing: it cannot be made, or the session has ended
    std::uint64_t m_keptRevision = 0;
    SessionState m_keptState;
    bool m_otherDocument = true; ///< since the last time
    bool m_failed = false;       ///< which is reported once
    QTimer m_timer;
    NewestTask m_task; ///< last: its thread ends before what it posts to
};

} // namespace proveout
