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
/// Errors with line and column, all of them at once: syntax; a key or table that is not known; a row without
/// number or cutter, a number that is no positive whole number or comes twice, a cutter that no shape fits.
[[nodiscard]] Result<ToolTable> readToolFile(const std::filesystem::path& file);

} // namespace proveout
