// SPDX-License-Identifier: GPL-3.0-or-later
// Tool numbers, alike in programs, tool tables, job files and on the command line.
#pragma once

#include <optional>
#include <string_view>

namespace proveout {

/// Tools are numbered from 0 on. In a program 0 empties the spindle, unless the tool table has a cutter for
/// it.
inline constexpr int kLeastTool = 0;
inline constexpr int kLargestTool = 99'999'999;

/// The number that `text` is as a whole; nothing where it is none from kLeastTool to kLargestTool.
[[nodiscard]] std::optional<int> parseToolNumber(std::string_view text);

} // namespace proveout
