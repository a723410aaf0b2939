// SPDX-License-Identifier: GPL-3.0-or-later
// The machine time as text.
#pragma once

#include <QString>

#include "core/simulation/setup/tool_choice.h"
#include "core/simulation/time/machine_time.h"

namespace proveout {

/// "1:02:03"; "> 999999:59:59" above a million hours.
[[nodiscard]] QString clockText(double seconds);
/// The machine time by kind of motion and by tool, and the assumptions behind it. Several lines.
[[nodiscard]] QString timeTip(const MachineTimes& times, bool assumed, const ToolChoice& choice,
                              const ToolTable& tools);

} // namespace proveout
