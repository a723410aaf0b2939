// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "core/cutter/tool_table.h"

namespace proveout::cli {

/// One object per tool: number, cutter, source; for a tool from a comment also its line and text, and which
/// sizes of the cutter are defaults.
[[nodiscard]] nlohmann::ordered_json toolsAsJson(const ToolTable& table);

/// Prints the tools on stdout, one per line. `unconfirmedOnly`: only those with sizes that were not entered.
void printTools(const ToolTable& table, bool unconfirmedOnly);

} // namespace proveout::cli
