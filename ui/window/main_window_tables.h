// SPDX-License-Identifier: GPL-3.0-or-later
// The rows that the main window is made of.
#pragma once

#include <QMainWindow>

#include "ui/window/main_window.h"

namespace proveout {

/// One row a dock; adding a panel is adding a row.
struct MainWindow::Dock {
    const char* id; ///< objectName, for saved layouts
    const char* title;
    const char* icon;
    const char* keys;
    bool titleBar;
    QWidget* (*make)(MainWindow&);
};

inline constexpr const char* kMenuContext = "Menus";
inline constexpr const char* kFileContext = "FileCommands";
inline constexpr const char* kMeshContext = "MeshCommands";
inline constexpr const char* kWindowContext = "WindowCommands";
inline constexpr const char* kHelpContext = "HelpCommands";
inline constexpr const char* kDockContext = "Docks";

} // namespace proveout
