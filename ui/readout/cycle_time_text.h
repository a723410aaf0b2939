// SPDX-License-Identifier: GPL-3.0-or-later
// The machine's time in words.
#pragma once

#include <QString>

#include "core/simulation/setup/tool_choice.h"
#include "core/simulation/time/machine_time.h"

namespace proveout {

/// "1:02:03"; "> 999999:59:59" beyond a million hours.
[[nodiscard]] QString clockText(double seconds);
/// Where the time goes, by parts and tools, and what was assumed for it. Several lines.
[[nodiscard]] QString timeTip(const MachineTimes& times, bool assumed, const ToolChoice& choice,
                              const ToolTable& tools);

} // namespace proveout
