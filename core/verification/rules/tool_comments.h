// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/diagnostic.h"
#include "core/cutter/tool_table.h"
#include "core/simulation/setup/tool_proposals.h"

namespace proveout {

/// Where the comments of a program describe another tool than the table has: of another diameter, or of
/// another kind, such as a drill in place of an end mill. Only for tools that the program calls and whose
/// sizes in the table are given. At the lines of the comments, one per tool. Pure, any thread.
[[nodiscard]] Diagnostics differingComments(const ToolProposals& proposals, const ToolTable& tools);

} // namespace proveout
