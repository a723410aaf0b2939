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

/// Keeps the unsaved work of a window, and offers what sessions before it have left that were ended from
/// outside: each can be restored, compared with its files, or discarded; what is neither stays for the next
/// start. Thread: UI.
class Recovery final : public QObject {
    Q_OBJECT

public:
    /// The window outlives this object. Below `root` each session has a folder.
    Recovery(MainWindow& window, const QString& root);

    /// Where the application keeps such sessions.
    [[nodiscard]] static QString defaultRoot();
    /// The window was closed with the consent of the user: nothing of it is unsaved.
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
    std::vector<Left> m_left; ///< the newest first
    RecoveryBar* m_bar;
    Autosave m_autosave;
};

} // namespace proveout
