// SPDX-License-Identifier: GPL-3.0-or-later
// Random programs in LinuxCNC's language, with every code and with words in any sequence.
#pragma once

#include <map>
#include <random>
#include <string>
#include <vector>

#include "core/nc/state/tool_offsets.h"

namespace proveout::test {

/// The tools that the programs use.
[[nodiscard]] std::map<int, ToolOffset> toolsOfRandomPrograms();

/// The lines of a program. Most programs can be run; some contradict themselves.
[[nodiscard]] std::vector<std::string> randomProgram(std::mt19937& random);

} // namespace proveout::test
