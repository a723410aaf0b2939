// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <QObject>
#include <QString>

#include "ui/document/kept_session.h"
#include "ui/files/autosave.h"

namespace proveout {

class MainWindow;
class RecoveryBar;

/// Backs up the unsaved work of a window, and offers the backups of earlier sessions that ended unexpectedly:
/// each can be restored, compared with its files, or discarded; otherwise it stays for the next start.
/// Thread: UI.
class Recovery final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive this object. Each session has a folder below `root`.
    Recovery(MainWindow& window, const QString& root);

    /// Where the application keeps the backups.
    [[nodiscard]] static QString defaultRoot();
    /// The window was closed by the user, so it has no unsaved work.
    void end() { m_autosave.end(); }
    [[nodiscard]] Autosave& autosave() { return m_autosave; }

private:
    struct Left {
        SessionFolder folder;
        KeptSession session;
    };

    void find(const QString& root);
    void show();
    void restore(const QString& folder);
    void compare(const QString& folder);
    void discard(const QString& folder);
    void forget(const QString& folder);
    [[nodiscard]] Left* leftIn(const QString& folder);

    MainWindow& m_window;
    std::vector<Left> m_left; ///< newest first
    RecoveryBar* m_bar;
    Autosave m_autosave;
};

} // namespace proveout
