// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "core/cutter/tool_table.h"

namespace proveout::cli {

/// One object a tool: number, cutter, source; and of what was read from a comment its line and text, and what
/// of the cutter is a default.
[[nodiscard]] nlohmann::ordered_json toolsAsJson(const ToolTable& table);

/// Prints the tools on stdout, one a line. `unconfirmedOnly`: those whose sizes are not given.
void printTools(const ToolTable& table, bool unconfirmedOnly);

} // namespace proveout::cli
