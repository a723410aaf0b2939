// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/cutter/tool_spec.h"
#include "core/cutter/tool_table.h"

namespace proveout {

/// The origin of the sizes of an unconfirmed tool after the user has changed `before` into `after`: an
/// entered size is no longer a default. Empty: the tool is confirmed, because its diameter (for a form
/// cutter, its profile) was entered; no other size identifies the cutter.
[[nodiscard]] std::optional<ToolOrigin> editedOrigin(ToolOrigin origin, const ToolSpec& before,
                                                     const ToolSpec& after);

} // namespace proveout
