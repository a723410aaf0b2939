// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "ui/look/command_table.h"
#include "ui/viewport/viewport.h"

namespace proveout {

/// The commands of the 3D view, one per row.
[[nodiscard]] std::span<const Command<Viewport>> viewportCommands();
/// Adds them to the view as actions; those that can be turned on show whether they are.
[[nodiscard]] std::unique_ptr<CommandActions<Viewport>> addCommands(Viewport& viewport);
/// After another cause than a command.
void showSwitches(const Viewport& viewport, const CommandActions<Viewport>& commands);

/// Whether a command that can be turned on is on; empty for other commands.
[[nodiscard]] std::optional<bool> isOn(const Viewport& viewport, std::string_view id);

} // namespace proveout
