// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "core/simulation/setup/tool_choice.h"
#include "core/simulation/time/machine_time.h"

namespace proveout::cli {

/// `machineSeconds` of the report: the whole program by parts and tools, and what `blocks` of it take.
/// `assumed`: nobody has described the machine. `tools`: of the program.
[[nodiscard]] nlohmann::ordered_json machineSeconds(const MachineTimes& times, std::size_t blocks,
                                                    bool assumed, const ToolChoice& tools);

/// "1:02:03".
[[nodiscard]] std::string clockText(double seconds);

} // namespace proveout::cli
