// SPDX-License-Identifier: GPL-3.0-or-later
// Where the docks are: one row a layout, read by the Layout menu, the main window and tests.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <QMainWindow>

#include "ui/program/playback.h"

namespace proveout {

/// Docks (by objectName) that share a place as tabs; the first one is in front.
using DockTabs = std::vector<const char*>;

/// A side of the view in the middle.
enum class DockArea : std::uint8_t { left, right, bottom };

/// One arrangement of the window. Static data.
struct DockLayout {
    const char* id; ///< kept in the settings, and the objectName of its action behind "layout-"
    const char* title;
    const char* tip;
    std::vector<DockTabs> left; ///< columns from the top down
    std::vector<DockTabs> right;
    std::vector<DockTabs> bottom; ///< rows over the whole width, from the top down
    PlayBy playBy;                ///< what the speed of playback counts
    double speed;                 ///< times unitSpeed(playBy)
    /// Share of the window's height of all rows at the bottom but the last, which has its own height.
    double bottomShare;
};

/// The first one is that of a new user.
[[nodiscard]] std::span<const DockLayout> dockLayouts();
/// The layout with this id; the first one where there is none.
[[nodiscard]] const DockLayout& dockLayout(std::string_view id);

/// Names a dock in a layout that does not: as the last tab of the first place of `area`. `id` is static data.
void placeUnnamed(DockLayout& layout, const char* id, DockArea area);

/// Puts the docks that the layout names where it has them, all shown. Sizes follow from the window's own: it
/// must have its size.
void arrangeDocks(QMainWindow& window, const DockLayout& layout);

/// The width that the leftmost docks get in a window of `windowWidth`, where the widest content of them
/// wants `wanted`. Pixels.
[[nodiscard]] int leftDockWidth(int windowWidth, int wanted);

} // namespace proveout
