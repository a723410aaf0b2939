// SPDX-License-Identifier: GPL-3.0-or-later
// The panels of the window: one row a panel, read by docks, layouts, menus and tests.
#pragma once

#include <cstdint>
#include <span>

#include <QString>

#include "ui/window/dock_layouts.h"

class QWidget;

namespace proveout {

class PlaybackCommands;
class Session;

/// Which menu has the actions() of a panel.
enum class PanelMenu : std::uint8_t { none, edit, view };

/// What panels are made from; it outlives them.
struct PanelParts {
    Session& session;
    const PlaybackCommands& playback;
};

/// One panel in its dock. Static data; adding a panel is adding a row.
struct PanelRow {
    /// objectName of the dock, kept in saved layouts: "dock-" and the name of the panel's page of the guide.
    const char* id = "";
    const char* title = ""; ///< marked with QT_TRANSLATE_NOOP under "Docks"
    const char* icon = "";  ///< of :/icons
    const char* keys = "";  ///< bring the panel forward; may be empty
    /// The panel, owned by `parent` or by what it is put into.
    QWidget* (*make)(const PanelParts& parts, QWidget* parent) = nullptr;
    DockArea area = DockArea::bottom; ///< in the layouts that do not name the panel
    bool titleBar = true;
    bool fitted = false;   ///< as wide as the content wants to be; of one panel, at the left
    bool editsJob = false; ///< shows setup, parameters or machine: Undo acts on these with the focus here
    PanelMenu menu = PanelMenu::none;
    const char* submenu =
        ""; ///< title of a menu in `menu` for the actions, marked under "Menus"; may be empty
    /// The translated title with a mark for what the panel shows; null for a panel without marks.
    QString (*marked)(const QString& title, const Session& session) = nullptr;
};

/// In the order of their keys and of the Window menu.
[[nodiscard]] std::span<const PanelRow> panelTable();

/// Panels that the window itself brings forward.
inline constexpr const char* kProgramPanel = "dock-program";
inline constexpr const char* kSetupPanel = "dock-setup";
inline constexpr const char* kTuningPanel = "dock-tuning";
inline constexpr const char* kProblemsPanel = "dock-problems";

} // namespace proveout
