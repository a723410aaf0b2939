// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QMainWindow>

#include "ui/appearance.h"
#include "ui/command_table.h"
#include "ui/file_flow.h"
#include "ui/playback_commands.h"
#include "ui/session/session.h"

class QStackedWidget;

namespace proveout {

class EditorPanel;
class FittedDock;
class KeptSwitches;
class LayoutMenu;
class PanelFocus;
class ProblemsPanel;
class StartPage;
class StatusLine;
class TimelinePanel;
class UndoCommands;

/// The workstation's window: panels in docks round the 3D view, menus and tool bars made from tables.
class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    /// Session and appearance outlive the window.
    MainWindow(Session& session, Appearance& appearance);
    ~MainWindow() override;

    [[nodiscard]] FileFlow& files() { return *m_files; }
    [[nodiscard]] Session& session() { return m_session; }
    [[nodiscard]] Appearance& appearance() { return m_appearance; }
    [[nodiscard]] EditorPanel& editor() { return *m_editor; }
    [[nodiscard]] QWidget& viewport() { return *m_viewport; }
    /// The action with this objectName, of whatever table; null where there is none.
    [[nodiscard]] QAction* action(const QString& id) const;

    /// Sizes and places of the window and its docks, to be restored later.
    [[nodiscard]] QByteArray layout() const;
    /// Leaves all as it is where `layout` is not one of this version.
    void setLayout(const QByteArray& layout);
    /// Shows a message above the view or the start page, which shares the room with it; takes ownership.
    void addNotice(QWidget* notice);
    void resetLayout();
    void toggleFullScreen();
    void showStartPage();
    void showAbout();
    void showShortcuts();
    void showTuning();

protected:
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Dock;
    static const std::vector<Dock>& docks();
    /// Ids of actions in the order of the tool bar; "" is a separator.
    static std::span<const char* const> toolBarIds();
    static std::span<const Command<MainWindow>> fileCommands();
    static std::span<const Command<MainWindow>> meshCommands();
    static std::span<const Command<MainWindow>> windowCommands();
    static std::span<const Command<MainWindow>> helpCommands();

    void makePanels();
    void makeDocks();
    void arrange();
    void restorePlayback();
    void raiseFloatingDocks();
    void makeMenus();
    void makeToolBar();
    QMenu* addMenu(const char* title, const QList<QAction*>& actions);
    void fillChoices();
    void fillSamples();
    void retranslate();
    void titleDocks();
    void showProblems();
    void editNewProgram();
    void restore();
    void showDocument();
    void titleWindow();

    Session& m_session;
    Appearance& m_appearance;
    FileFlow* m_files;
    PlaybackCommands* m_playback;
    StatusLine* m_status;

    QStackedWidget* m_centre;
    StartPage* m_startPage;
    QWidget* m_viewport = nullptr;
    EditorPanel* m_editor = nullptr;
    QWidget* m_plots = nullptr;
    ProblemsPanel* m_problems = nullptr;
    TimelinePanel* m_timeline = nullptr;
    UndoCommands* m_undo = nullptr;
    PanelFocus* m_focus = nullptr;
    FittedDock* m_editorDock = nullptr;
    std::vector<QDockWidget*> m_docks;                   ///< in the order of docks()
    std::vector<std::pair<QMenu*, const char*>> m_menus; ///< with their untranslated titles
    QMenu* m_samplesMenu = nullptr;
    LayoutMenu* m_layoutMenu = nullptr;
    QMenu* m_themeMenu = nullptr;
    QMenu* m_languageMenu = nullptr;
    QToolBar* m_toolBar = nullptr;
    KeptSwitches* m_viewOptions = nullptr;
    bool m_layoutKept = false; ///< the docks are where the settings have them

    CommandActions<MainWindow> m_fileCommands;
    CommandActions<MainWindow> m_meshCommands;
    CommandActions<MainWindow> m_windowCommands;
    CommandActions<MainWindow> m_helpCommands;
};

} // namespace proveout
