// SPDX-License-Identifier: GPL-3.0-or-later
// Names of what ControlState lists, by which it is found again.
#pragma once

#include "core/base/text.h"

namespace proveout::control_name {

/// Its value is the number of a tool.
inline constexpr const char* kSpindleTool = PROVEOUT_TEXT("Core", "Tool in the spindle");

} // namespace proveout::control_name
