// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/base/diagnostic.h"
#include "core/cutter/tool_table.h"

namespace proveout {

/// Reads a tool table, TOML:
///     [[tool]]
///     number = 1
///     cutter = "ball:d=11,l=50"
///     source = "assumed"           # the sizes are not confirmed; "given" where the key is missing
/// Errors with line and column, all of them at once: syntax; an unknown key or table; a row without number or
/// cutter, an invalid tool number or one that occurs twice, a cutter that fits no shape.
[[nodiscard]] Result<ToolTable> readToolFile(const std::filesystem::path& file);

} // namespace proveout
