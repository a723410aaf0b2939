// SPDX-License-Identifier: GPL-3.0-or-later
// The panels of the window: one row per panel, used by docks, layouts, menus and tests.
#pragma once

#include <cstdint>
#include <span>

#include <QString>

#include "ui/window/dock_layouts.h"

class QWidget;

namespace proveout {

class PlaybackCommands;
class Session;

/// The menu that contains the actions() of a panel.
enum class PanelMenu : std::uint8_t { none, edit, view };

/// What panels are constructed from; it must outlive them.
struct PanelParts {
    Session& session;
    const PlaybackCommands& playback;
};

/// One panel in its dock. Static data; to add a panel, add a row.
struct PanelRow {
    /// objectName of the dock, stored in saved layouts: "dock-" and the name of the panel's page in the
    /// guide.
    const char* id = "";
    const char* title = ""; ///< marked with QT_TRANSLATE_NOOP in the context "Docks"
    const char* icon = "";  ///< in :/icons
    const char* keys = "";  ///< shortcuts that bring the panel to the front; may be empty
    /// Creates the panel, owned by `parent` or by the widget that contains it.
    QWidget* (*make)(const PanelParts& parts, QWidget* parent) = nullptr;
    DockArea area = DockArea::bottom; ///< for layouts that do not name the panel
    bool titleBar = true;
    bool fitted = false;   ///< as wide as its content requires; only for one panel, at the left
    bool editsJob = false; ///< shows setup, parameters or machine: with the focus here, Undo applies to these
    PanelMenu menu = PanelMenu::none;
    const char* submenu =
        ""; ///< title of a submenu of `menu` for the actions, marked in the context "Menus"; may be empty
    /// Adds a mark about the panel's content to the translated title; null for a panel without marks.
    QString (*marked)(const QString& title, const Session& session) = nullptr;
};

/// Same order as their shortcuts and the Window menu.
[[nodiscard]] std::span<const PanelRow> panelTable();

/// Panels that the window itself brings to the front.
inline constexpr const char* kProgramPanel = "dock-program";
inline constexpr const char* kSetupPanel = "dock-setup";
inline constexpr const char* kTuningPanel = "dock-tuning";
inline constexpr const char* kProblemsPanel = "dock-problems";

} // namespace proveout
