// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the window itself: one row per command, used by menus, tool bar and tests.
#pragma once

#include <span>

#include "ui/look/command_table.h"

namespace proveout {

class MainWindow;

inline constexpr const char* kFileContext = "FileCommands";
inline constexpr const char* kMeshContext = "MeshCommands";
inline constexpr const char* kWindowContext = "WindowCommands";
inline constexpr const char* kHelpContext = "HelpCommands";

[[nodiscard]] std::span<const Command<MainWindow>> fileCommands();
[[nodiscard]] std::span<const Command<MainWindow>> meshCommands();
[[nodiscard]] std::span<const Command<MainWindow>> windowCommands();
[[nodiscard]] std::span<const Command<MainWindow>> helpCommands();

/// Ids of actions from any table, in the sequence of the tool bar; "" is a separator.
[[nodiscard]] std::span<const char* const> toolBarIds();

} // namespace proveout
