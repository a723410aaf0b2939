// SPDX-License-Identifier: GPL-3.0-or-later
// The arrangement of the docks: one row per layout, used by the Layout menu, the main window and tests.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <QMainWindow>

#include "ui/program/playback.h"

namespace proveout {

/// Docks (by objectName) that share an area as tabs; the first one is in front.
using DockTabs = std::vector<const char*>;

/// A side of the central view.
enum class DockArea : std::uint8_t { left, right, bottom };

/// One arrangement of the window's docks. Static data.
struct DockLayout {
    const char* id; ///< stored in the settings; also the objectName of its action, after "layout-"
    const char* title;
    const char* tip;
    std::vector<DockTabs> left; ///< columns from top to bottom
    std::vector<DockTabs> right;
    std::vector<DockTabs> bottom; ///< rows over the full width, from top to bottom
    PlayBy playBy;                ///< the unit of the playback speed
    double speed;                 ///< a multiple of unitSpeed(playBy)
    /// Share of the window's height for all rows at the bottom except the last, which has a height of its
    /// own.
    double bottomShare;
};

/// The first one is the default for new users.
[[nodiscard]] std::span<const DockLayout> dockLayouts();
/// The layout with this id, or the first one if there is no such layout.
[[nodiscard]] const DockLayout& dockLayout(std::string_view id);

/// Adds a dock to a layout that does not contain it, as the last tab of the first tab group in `area`. `id`
/// is static data.
void placeUnnamed(DockLayout& layout, const char* id, DockArea area);

/// Arranges and shows the docks that the layout names. Sizes depend on the size of the window, which must be
/// set already.
void arrangeDocks(QMainWindow& window, const DockLayout& layout);

/// The width of the leftmost docks in a window of `windowWidth`, if their widest content needs `wanted`.
/// Pixels.
[[nodiscard]] int leftDockWidth(int windowWidth, int wanted);

} // namespace proveout
