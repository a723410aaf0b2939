// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ui/look/command_table.h"
#include "ui/viewport/viewport.h"

namespace proveout {

/// The commands of the 3D view: one row a command.
[[nodiscard]] std::span<const Command<Viewport>> viewportCommands();
inline constexpr const char* kViewportCommandContext = "ViewportCommands";

/// For a command that is on or off: whether it is on; empty for the others.
[[nodiscard]] std::optional<bool> isOn(const Viewport& viewport, std::string_view id);

} // namespace proveout
