// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <QList>
#include <QMenu>
#include <QObject>

#include "ui/look/command_table.h"
#include "ui/window/panel_table.h"

namespace proveout {

class AppearanceMenus;
class LayoutMenu;
class MainWindow;
class PanelDocks;
class PlaybackCommands;
class UndoCommands;

/// The menu bar of the window: the commands of the window's tables, of the view and of the panels, and the
/// menus of files, layouts and appearance. Thread: UI.
class WindowMenus final : public QObject {
    Q_OBJECT

public:
    /// Fills the menu bar of `window`, whose files, view and panels must exist already. All arguments must
    /// outlive this object.
    WindowMenus(MainWindow& window, const UndoCommands& undo, const PlaybackCommands& playback);

    [[nodiscard]] LayoutMenu& layouts() { return *m_layouts; }
    void retranslate();
    /// Call it when the theme has changed.
    void followTheme();

private:
    void addFile();
    void addEdit(const UndoCommands& undo);
    void addView(const PlaybackCommands& playback);
    void addSimulate(const PlaybackCommands& playback);
    void addMemory(QMenu& menu);
    void addMesh();
    void addWindow();
    void addHelp();
    QMenu& add(const char* title, const QList<QAction*>& actions);
    void addTitled(QMenu& menu, const char* title);
    void addOfPanels(QMenu& menu, PanelMenu place);
    void fillSamples();

    MainWindow& m_window;
    CommandActions<MainWindow> m_file;
    CommandActions<MainWindow> m_mesh;
    CommandActions<MainWindow> m_ofWindow;
    CommandActions<MainWindow> m_help;
    AppearanceMenus* m_appearance;
    LayoutMenu* m_layouts;
    QMenu* m_samples;
    std::vector<std::pair<QMenu*, const char*>> m_titles; ///< untranslated
};

} // namespace proveout
