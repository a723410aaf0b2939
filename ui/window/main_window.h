// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QMainWindow>

#include "ui/files/file_flow.h"
#include "ui/look/appearance.h"
#include "ui/session/session.h"

namespace proveout {

class EditorPanel;
class KeptSwitches;
class PanelDocks;
class PlaybackCommands;
class StatusLine;
class UndoCommands;
class WindowCentre;
class WindowMenus;
class WindowState;
class WindowToolBar;

/// The workstation's window: panels in docks around the 3D view, menus and tool bar created from tables. It
/// creates its parts and connects them with the session.
class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    /// Session and appearance must outlive the window.
    MainWindow(Session& session, Appearance& appearance);
    ~MainWindow() override;

    [[nodiscard]] FileFlow& files() { return *m_files; }
    [[nodiscard]] Session& session() { return m_session; }
    [[nodiscard]] Appearance& appearance() { return m_appearance; }
    [[nodiscard]] PanelDocks& docks() { return *m_docks; }
    [[nodiscard]] EditorPanel& editor();
    [[nodiscard]] QWidget& viewport();
    /// The action with this objectName from any table; null if there is none.
    [[nodiscard]] QAction* action(const QString& id) const;

    /// Sizes and positions of the window and its docks, for restoring them later.
    [[nodiscard]] QByteArray layout() const;
    /// Does nothing if `layout` was stored by another version.
    void setLayout(const QByteArray& layout);
    /// Shows a message above the view or the start page, which becomes smaller; takes ownership.
    void addNotice(QWidget* notice);
    void resetLayout();
    void toggleFullScreen();
    void showStartPage();

protected:
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void followFiles();
    void followStartPage();
    void followSession();
    void showProgramForSearch();
    void retranslate();
    void keepFloatingDocksInFront();
    void showDocument();
    void titleWindow();

    Session& m_session;
    Appearance& m_appearance;
    FileFlow* m_files;
    PlaybackCommands* m_playback;
    StatusLine* m_status;
    WindowCentre* m_centre;
    PanelDocks* m_docks;
    UndoCommands* m_undo;
    WindowMenus* m_menus = nullptr;
    WindowToolBar* m_toolBar = nullptr;
    std::unique_ptr<WindowState> m_state;
    KeptSwitches* m_viewOptions = nullptr;
};

} // namespace proveout
