// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "core/simulation/setup/tool_choice.h"
#include "core/simulation/time/machine_time.h"

namespace proveout::cli {

/// `machineSeconds` of the report: the times of the whole program by kind of motion and by tool, and the time
/// of the first `blocks` blocks. `assumed`: default values are used for the machine. `tools`: those of the
/// program.
[[nodiscard]] nlohmann::ordered_json machineSeconds(const MachineTimes& times, std::size_t blocks,
                                                    bool assumed, const ToolChoice& tools);

/// "1:02:03".
[[nodiscard]] std::string clockText(double seconds);

} // namespace proveout::cli
