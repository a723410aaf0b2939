// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/cutter/tool_table.h"
#include "ui/setup/tool_spec.h"

namespace proveout {

/// Where the sizes of an unconfirmed tool come from after the user has changed `before` into `after`: what
/// was entered is no default any more. Nothing: the tool is confirmed, because its diameter (of a form
/// cutter, its profile) was entered; no other size says what cutter it is.
[[nodiscard]] std::optional<ToolOrigin> editedOrigin(ToolOrigin origin, const ToolSpec& before,
                                                     const ToolSpec& after);

} // namespace proveout
