// SPDX-License-Identifier: GPL-3.0-or-later
// Tool numbers, which have the same limits in programs, tool tables, job files and on the command line.
#pragma once

#include <optional>
#include <string_view>

namespace proveout {

/// Tool numbers start at 0. In a program, 0 empties the spindle, unless the tool table has a cutter for it.
inline constexpr int kLeastTool = 0;
inline constexpr int kLargestTool = 99'999'999;

/// The number that the whole of `text` is; nothing if it is not a number from kLeastTool to kLargestTool.
[[nodiscard]] std::optional<int> parseToolNumber(std::string_view text);

} // namespace proveout
